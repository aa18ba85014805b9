#include "experiments/comparison/tuner.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr std::uint64_t kTrainingSeedOffset =
    1000003;  // the training layouts must differ from those of comparisons
constexpr int kMostEvaluations = 100000;
constexpr double kFirstSpread = 0.1, kLastSpread = 0.002;  // of tries near the best, see tuningSpread
constexpr double kOwnSize = 10.0, kZeroSize = 0.1;
constexpr double kAnywhere = 1.0 / 3.0;  // share of tries over the whole ranges
constexpr double kMoved = 0.3;           // share of the parameters that a try near the best changes
constexpr std::size_t kFinalists = 5;
constexpr int kLastRound = 3;  // factor of the number of layouts

using Point = std::vector<double>;

struct Space {
  std::string fixed;  ///< name and fixed settings of the method
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

/// A point near `best` with at least one parameter changed. The standard deviation is `spread` times the
/// smaller of the parameter's range and ten times its value.
Point drawNear(const Space& space, Rng& rng, const Point& best, double spread) {
  Point point = best;
  const std::size_t always = rng.below(static_cast<std::uint32_t>(point.size()));
  for (std::size_t i = 0; i < point.size(); ++i) {
    const bool moved = rng.uniform(0.0, 1.0) < kMoved || i == always;
    if (!moved) continue;
    const ParameterSpec& spec = space.parameters[i];
    const double range = spec.maximum - spec.minimum;
    // The value's own size limits the change, since some values are centimetres in a range of metres.
    const double size = best[i] != 0.0 ? std::min(range, kOwnSize * std::abs(best[i])) : kZeroSize * range;
    point[i] = std::clamp(best[i] + rng.normal(0.0, spread * size), spec.minimum, spec.maximum);
  }
  return point;
}

struct Candidate {
  Point point;
  double value = 0.0;
};

/// Inserts a candidate into the list of the best, which is sorted by value.
void keepBest(std::vector<Candidate>& best, Candidate candidate) {
  const auto place = std::upper_bound(best.begin(), best.end(), candidate.value,
                                      [](double value, const Candidate& c) { return value < c.value; });
  best.insert(place, std::move(candidate));
  if (best.size() > kFinalists) best.pop_back();
}

/// The comparison on whose layouts the candidates are tried.
ComparisonConfig trainingOf(const ComparisonConfig& base, const TuneConfig& config) {
  ComparisonConfig training = base;
  if (training.suite == kPaperSuite) training.suite = "corner";
  training.speeds = {config.speed};
  training.trials = config.layouts;
  training.seed = base.seed + kTrainingSeedOffset;
  training.pictures = 0;
  training.only.reset();
  training.record.clear();
  return training;
}

/// The function to minimise. It measures candidates one after the other and reports each to `progress`.
class Objective {
 public:
  Objective(const Space& space, ComparisonConfig training, std::size_t total, const Progress& progress)
      : space_(space), training_(std::move(training)), total_(total), progress_(progress) {}

  /// The mean T/T* at `point`. Errors: kInterrupted, and those of a comparison.
  Result<double> operator()(const Point& point) {
    if (progress_ && !progress_(done_++, total_)) return fail(ErrorCode::kInterrupted, "interrupted");
    training_.navigators = {specificationAt(space_, point)};
    auto comparison = planComparison(training_);
    if (!comparison) return tl::unexpected<Error>(comparison.error());
    // A measurement takes seconds, so the user can stop it after each trial.
    const auto in_between = [&](std::size_t, std::size_t) { return !progress_ || progress_(done_, total_); };
    if (auto ran = runComparison(*comparison, {}, in_between); !ran)
      return tl::unexpected<Error>(ran.error());
    return comparison->summary.front().time_ratio_all;
  }

  /// Changes to more layouts, which are new.
  void beginLastRound() {
    training_.seed += kTrainingSeedOffset;
    training_.trials *= kLastRound;
  }
  int layouts() const { return training_.trials; }

 private:
  const Space& space_;
  ComparisonConfig training_;
  std::size_t total_;
  const Progress& progress_;
  std::size_t done_ = 0;
};

/// The best candidates of a seeded random search.
Result<std::vector<Candidate>> search(const Space& space, int evaluations, std::uint64_t seed,
                                      Objective& objective) {
  Rng rng(seed, Stream::kTuner);
  std::vector<Candidate> best;
  for (int i = 0; i < evaluations; ++i) {
    const double share = static_cast<double>(i) / evaluations;
    const double local = (share - kAnywhere) / (1.0 - kAnywhere);  // from 0 to 1 in the last two thirds
    Point point = defaults(space);
    if (i > 0) {
      point = local < 0.0 ? drawAnywhere(space, rng)
                          : drawNear(space, rng, best.front().point, tuningSpread(local));
    }
    const auto value = objective(point);
    if (!value) return tl::unexpected<Error>(value.error());
    keepBest(best, {std::move(point), *value});
  }
  return best;
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
  const std::size_t total = static_cast<std::size_t>(config.evaluations) + kFinalists + 1;
  Objective objective(*space, trainingOf(base, config), total, progress);
  auto finalists = search(*space, config.evaluations, base.seed, objective);
  if (!finalists) return tl::unexpected<Error>(finalists.error());

  objective.beginLastRound();
  TuneResult result;
  result.evaluations = config.evaluations;
  result.layouts = objective.layouts();
  finalists->insert(finalists->begin(), {defaults(*space), 0.0});
  for (std::size_t i = 0; i < finalists->size(); ++i) {
    const Point& point = (*finalists)[i].point;
    const auto value = objective(point);
    if (!value) return tl::unexpected<Error>(value.error());
    if (i == 0) result.initial = *value;
    if (i > 0 && *value >= result.objective) continue;
    result.objective = *value;
    result.navigator = specificationAt(*space, point);
  }
  return result;
}

}  // namespace fulbito
