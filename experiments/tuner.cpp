#include "experiments/tuner.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/random.hpp"
#include "experiments/paper_plan.hpp"

namespace fulbito {
namespace {

constexpr std::uint64_t kTrainingSeedOffset =
    1000003;  // training layouts are not those that the method is judged on
constexpr int kMostEvaluations = 100000;
constexpr double kLocalSpread = 0.1;  // of a parameter's range, near the best

using Point = std::vector<double>;

struct Space {
  std::string fixed;  ///< name and fixed settings
  std::vector<ParameterSpec> parameters;
};

Result<Space> spaceOf(const std::string& specification) {
  const auto choice = parseNavigator(specification);
  if (!choice) return tl::unexpected<Error>(choice.error());
  Space space{specification, {}};
  for (const ParameterSpec& spec : choice->info->parameters) {
    const bool held = std::any_of(choice->settings.begin(), choice->settings.end(),
                                  [&](const Setting& s) { return s.name == spec.name; });
    if (!held && spec.type == ParameterSpec::Type::kNumber) space.parameters.push_back(spec);
  }
  if (space.parameters.empty()) {
    return fail(ErrorCode::kUsage,
                fmt::format("--tune: '{}' has no numeric parameter to tune", specification));
  }
  return space;
}

std::string specificationAt(const Space& space, const Point& point) {
  std::string text = space.fixed;
  for (std::size_t i = 0; i < point.size(); ++i) {
    text += text.find(':') == std::string::npos ? ':' : ',';
    text += fmt::format("{}={:.4g}", space.parameters[i].name, point[i]);
  }
  return text;
}

Point defaults(const Space& space) {
  Point point;
  for (const ParameterSpec& spec : space.parameters) point.push_back(spec.default_value);
  return point;
}

Point draw(const Space& space, Rng& rng, const Point& best, bool local) {
  Point point;
  for (std::size_t i = 0; i < space.parameters.size(); ++i) {
    const ParameterSpec& spec = space.parameters[i];
    const double range = spec.maximum - spec.minimum;
    const double value =
        local ? best[i] + rng.normal(0.0, kLocalSpread * range) : rng.uniform(spec.minimum, spec.maximum);
    point.push_back(std::clamp(value, spec.minimum, spec.maximum));
  }
  return point;
}

}  // namespace

Result<TuneResult> tune(const ComparisonConfig& base, const TuneConfig& config, const Progress& progress) {
  if (config.evaluations < 1 || config.evaluations > kMostEvaluations) {
    return fail(ErrorCode::kUsage, fmt::format("--tune-evaluations: {} is outside 1 ... {}",
                                               config.evaluations, kMostEvaluations));
  }
  const auto space = spaceOf(config.navigator);
  if (!space) return tl::unexpected<Error>(space.error());
  ComparisonConfig training = base;
  if (training.suite == kPaperSuite) training.suite = "corner";
  training.speeds = {config.speed};
  training.trials = config.layouts;
  training.seed = base.seed + kTrainingSeedOffset;
  training.pictures = 0;
  training.only.reset();
  const auto objective = [&](const Point& point) -> Result<double> {
    training.navigators = {specificationAt(*space, point)};
    auto comparison = planComparison(training);
    if (!comparison) return tl::unexpected<Error>(comparison.error());
    if (auto ran = runComparison(*comparison, {}, {}); !ran) return tl::unexpected<Error>(ran.error());
    return comparison->summary.front().time_ratio_all;
  };
  Rng rng(base.seed, Stream::kTuner);
  Point best = defaults(*space);
  auto value = objective(best);
  if (!value) return tl::unexpected<Error>(value.error());
  TuneResult result{specificationAt(*space, best), *value, *value, 1};
  for (int i = 1; i < config.evaluations; ++i) {
    if (progress && !progress(static_cast<std::size_t>(i), static_cast<std::size_t>(config.evaluations))) {
      return fail(ErrorCode::kInterrupted, "interrupted");
    }
    const Point candidate = draw(*space, rng, best, 2 * i >= config.evaluations);
    value = objective(candidate);
    if (!value) return tl::unexpected<Error>(value.error());
    ++result.evaluations;
    if (*value >= result.objective) continue;
    best = candidate;
    result.objective = *value;
    result.navigator = specificationAt(*space, best);
  }
  return result;
}

}  // namespace fulbito
