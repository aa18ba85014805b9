#include "match/drills/trials.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/match.hpp"
#include "match/drills/trial_run.hpp"
#include "referee/rules/detector_schema.hpp"

namespace fulbito {
namespace {

constexpr double kEndless = 3600.0;  // [s] length of a half in trials: the drill's own duration ends them

int sizeFor(const Drill& drill, int size) {
  for (const DrillRobot& robot : drill.robots) size = std::max(size, robot.number + 1);
  return size;
}

}  // namespace

Result<MatchConfig> drillMatch(const DrillRun& run, const Drill& drill) {
  MatchConfig config;
  auto rules = loadRules(drill.rules);
  if (!rules) return tl::unexpected<Error>(rules.error());
  config.rules = std::move(*rules);
  auto field = loadField(config.rules.field);
  if (!field) return tl::unexpected<Error>(field.error());
  config.field = std::move(*field);
  config.robot = run.robot;
  config.physics = run.physics;
  config.rules.team_size = sizeFor(drill, config.rules.team_size);
  config.rules.half_seconds = drill.match_opponent.empty() ? kEndless : drill.half_seconds;
  config.vision.fill(drill.sight);
  if (!drill.referee) callOnlyGoals(config.rules);
  return config;
}

Result<DrillTrial> playTrial(const DrillRun& run, const Drill& drill, const MatchConfig& base, int index) {
  const auto trial = DrillTrialRun::create(run, drill, base, {run.options.seed, index});
  if (!trial) return tl::unexpected<Error>(trial.error());
  while ((*trial)->step()) {
  }
  return (*trial)->result();
}

void judge(DrillVerdict& verdict) {
  const DrillBar& bar = verdict.bar;
  const bool interval = bar.statistic == DrillStatistic::kRate && !bar.by_value;
  const double low = interval ? verdict.value.low : verdict.value.value;
  const double high = interval ? verdict.value.high : verdict.value.value;
  verdict.passed = verdict.count > 0 && !std::isnan(verdict.value.value) &&
                   !(std::isfinite(bar.at_least) && !(low >= bar.at_least)) &&
                   !(std::isfinite(bar.at_most) && !(high <= bar.at_most));
}

namespace {

double valueOf(const DrillTrial& trial, DrillMeasure measure) {
  switch (measure) {
    case DrillMeasure::kTime:
      return trial.time;
    case DrillMeasure::kExcess:
      return trial.time - trial.ideal;
    case DrillMeasure::kError:
      return trial.error;
    case DrillMeasure::kOnTarget:
      return trial.on_target ? 1.0 : 0.0;
    case DrillMeasure::kOwnGoal:
      return trial.own_goal ? 1.0 : 0.0;
    case DrillMeasure::kConceded:
      return trial.conceded ? 1.0 : 0.0;
    case DrillMeasure::kIllegal:
      return trial.illegal;
    default:
      return trial.success ? 1.0 : 0.0;
  }
}

/// Order statistic without interpolation, since failures are infinite.
double orderStatistic(std::vector<double>& values, double p) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

Interval statisticOf(const DrillBar& bar, std::vector<double>& values) {
  const auto sum = [&] {
    double total = 0.0;
    for (const double v : values) total += v;
    return total;
  };
  const auto plain = [](double v) { return Interval{v, v, v}; };
  switch (bar.statistic) {
    case DrillStatistic::kRate: {
      const bool limited = std::isfinite(bar.within);
      const auto hit = [&](double v) { return limited ? v <= bar.within : v > 0.5; };
      return wilson(static_cast<int>(std::count_if(values.begin(), values.end(), hit)),
                    static_cast<int>(values.size()));
    }
    case DrillStatistic::kCount:
      return plain(sum());
    case DrillStatistic::kMean:
      return plain(mean(values));
    case DrillStatistic::kMedian:
      return plain(orderStatistic(values, 0.5));
    case DrillStatistic::kP95:
      return plain(orderStatistic(values, 0.95));
  }
  return {};
}

}  // namespace

std::vector<DrillVerdict> judgeTrials(const Drill& drill, const std::vector<DrillTrial>& trials) {
  std::vector<DrillVerdict> verdicts;
  for (const DrillBar& bar : drill.bars) {
    std::vector<double> values, least;
    for (const DrillTrial& trial : trials) {
      const std::string& start = drill.starts[static_cast<std::size_t>(trial.start)].name;
      if (!trial.counted || (!bar.start.empty() && bar.start != start)) continue;
      values.push_back(valueOf(trial, bar.value));
      least.push_back(trial.ideal);
    }
    DrillVerdict verdict;
    verdict.bar = bar;
    verdict.count = static_cast<int>(values.size());
    verdict.value = statisticOf(bar, values);
    if (bar.of_least) {
      const double ratio = verdict.value.value / statisticOf(bar, least).value;
      verdict.value = {ratio, ratio, ratio};
    }
    judge(verdict);
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

}  // namespace fulbito
