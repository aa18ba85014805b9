#include "trials/comparison/tuner.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "trials/comparison/paper_plan.hpp"

namespace fulbito {
namespace {

constexpr std::uint64_t kTrainingSeedOffset =
    1000003;  // training layouts are not those that the method is judged on
constexpr int kMostEvaluations = 100000;
constexpr double kFirstSpread = 0.1, kLastSpread = 0.002;  // of tries near the best, see tuningSpread
constexpr double kOwnSize = 10.0, kZeroSize = 0.1;
constexpr double kAnywhere = 1.0 / 3.0;  // share of tries over the whole ranges
constexpr double kMoved = 0.3;           // share of the parameters that a try near the best changes
constexpr std::size_t kFinalists = 5;
constexpr int kLastRound = 3;  // times as many layouts

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

Point drawAnywhere(const Space& space, Rng& rng) {
  Point point;
  for (const ParameterSpec& spec : space.parameters) point.push_back(rng.uniform(spec.minimum, spec.maximum));
  return point;
}

/// `best` with at least one parameter changed, by `spread` times the smaller of its range and ten times its
/// value.
Point drawNear(const Space& space, Rng& rng, const Point& best, double spread) {
  Point point = best;
  const std::size_t always = rng.below(static_cast<std::uint32_t>(point.size()));
  for (std::size_t i = 0; i < point.size(); ++i) {
    const bool moved = rng.uniform(0.0, 1.0) < kMoved || i == always;
    if (!moved) continue;
    const ParameterSpec& spec = space.parameters[i];
    const double range = spec.maximum - spec.minimum;
    // A value of centimetres in a range of metres: its own size is the measure, a zero has none.
    const double size = best[i] != 0.0 ? std::min(range, kOwnSize * std::abs(best[i])) : kZeroSize * range;
    point[i] = std::clamp(best[i] + rng.normal(0.0, spread * size), spec.minimum, spec.maximum);
  }
  return point;
}

struct Candidate {
  Point point;
  double value = 0.0;
};

/// The first few candidates by value.
void keepBest(std::vector<Candidate>& best, Candidate candidate) {
  const auto place = std::upper_bound(best.begin(), best.end(), candidate.value,
                                      [](double value, const Candidate& c) { return value < c.value; });
  best.insert(place, std::move(candidate));
  if (best.size() > kFinalists) best.pop_back();
}

}  // namespace

double tuningSpread(double progress) {
  return kFirstSpread * math::exp(progress * math::log(kLastSpread / kFirstSpread));
}

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
  training.record.clear();
  const std::size_t total = static_cast<std::size_t>(config.evaluations) + kFinalists + 1;
  std::size_t done = 0;
  // An evaluation takes seconds: it can be stopped after each trial.
  const auto in_between = [&](std::size_t, std::size_t) { return !progress || progress(done, total); };
  const auto objective = [&](const Point& point) -> Result<double> {
    training.navigators = {specificationAt(*space, point)};
    auto comparison = planComparison(training);
    if (!comparison) return tl::unexpected<Error>(comparison.error());
    if (auto ran = runComparison(*comparison, {}, in_between); !ran)
      return tl::unexpected<Error>(ran.error());
    return comparison->summary.front().time_ratio_all;
  };
  const auto go_on = [&]() -> Result<void> {
    if (!progress || progress(done++, total)) return {};
    return fail(ErrorCode::kInterrupted, "interrupted");
  };

  Rng rng(base.seed, Stream::kTuner);
  std::vector<Candidate> best;
  for (int i = 0; i < config.evaluations; ++i) {
    if (auto on = go_on(); !on) return tl::unexpected<Error>(on.error());
    const double share = static_cast<double>(i) / config.evaluations;
    const double local = (share - kAnywhere) / (1.0 - kAnywhere);  // from 0 to 1 in the last two thirds
    Point point = defaults(*space);
    if (i > 0) {
      point = local < 0.0 ? drawAnywhere(*space, rng)
                          : drawNear(*space, rng, best.front().point, tuningSpread(local));
    }
    const auto value = objective(point);
    if (!value) return tl::unexpected<Error>(value.error());
    keepBest(best, {std::move(point), *value});
  }

  training.seed += kTrainingSeedOffset;
  training.trials = kLastRound * config.layouts;
  TuneResult result;
  result.evaluations = config.evaluations;
  result.layouts = training.trials;
  best.insert(best.begin(), {defaults(*space), 0.0});
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (auto on = go_on(); !on) return tl::unexpected<Error>(on.error());
    const auto value = objective(best[i].point);
    if (!value) return tl::unexpected<Error>(value.error());
    if (i == 0) result.initial = *value;
    if (i > 0 && *value >= result.objective) continue;
    result.objective = *value;
    result.navigator = specificationAt(*space, best[i].point);
  }
  return result;
}

}  // namespace fulbito
