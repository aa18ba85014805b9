#include "python/environments/drills/settings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/config/config_document.hpp"
#include "engine/core/system/text_file.hpp"

namespace fulbito {

Result<Drill> builtInDrill(int number) {
  const std::vector<Drill>& drills = builtInDrills();
  const auto found =
      std::find_if(drills.begin(), drills.end(), [&](const Drill& drill) { return drill.number == number; });
  if (found != drills.end()) return *found;
  return fail(ErrorCode::kUsage, fmt::format("drill: there is no drill {}; numbers are {} ... {}", number,
                                             drills.front().number, drills.back().number));
}

Result<Drill> drillOfFile(const std::string& file) {
  const auto text = readTextFile(file, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseDrill(*text, file);
}

Result<void> checkHasTrials(const Drill& drill) {
  if (drill.starts.empty() || !drill.match_opponent.empty()) {
    const char* const what = drill.repeats.empty() ? "plays whole matches" : "repeats other drills";
    return fail(ErrorCode::kUsage, fmt::format("drill: {} '{}' {}, so it has no trials to play as episodes",
                                               drill.number, drill.name, what));
  }
  const auto asks = [](const DrillStart& start) { return start.task == DrillTask::kPredictBall; };
  const auto count = std::count_if(drill.starts.begin(), drill.starts.end(), asks);
  if (count == 0 || count == static_cast<std::ptrdiff_t>(drill.starts.size())) return {};
  return fail(ErrorCode::kUsage,
              fmt::format("drill: {} '{}' mixes predictions with other tasks: their actions differ",
                          drill.number, drill.name));
}

}  // namespace fulbito
