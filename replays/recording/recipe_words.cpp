#include "replays/recording/recipe_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

std::string textOf(const SensorModel& sensors) {
  return fmt::format("latency {} ticks, noise {:g} mm and {:g}\u00b0, {:g} % not seen", sensors.latency_ticks,
                     sensors.position_noise * 1e3, sensors.heading_noise * 180.0 / math::kPi,
                     sensors.dropout * 100);
}

}  // namespace

std::string_view moreOf(const RecordingRecipe& recipe, std::string_view name) {
  for (const auto& [key, text] : recipe.more) {
    if (key == name) return text;
  }
  return {};
}

std::vector<std::string> teamNames(const RecordingRecipe& recipe) {
  std::vector<std::string> names = recipe.teams;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view own = moreOf(recipe, i == 0 ? "blue_team_name" : "yellow_team_name");
    if (!own.empty()) names[i] = own;
  }
  return names;
}

std::vector<std::pair<std::string, std::string>> visionWords(const RecordingRecipe& recipe) {
  const std::vector<SensorModel>& all = recipe.vision;
  if (std::all_of(all.begin(), all.end(), [](const SensorModel& s) { return s.perfect(); })) return {};
  if (all.size() < 2 || all[0] == all[1]) return {{"Vision", textOf(all[0])}};
  return {{"Blue's vision", textOf(all[0])}, {"Yellow's vision", textOf(all[1])}};
}

}  // namespace fulbito
