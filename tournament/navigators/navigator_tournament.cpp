#include "tournament/navigators/navigator_tournament.hpp"

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr double kLeastSpeed = 0.05;  // [m/s]
constexpr double kMostSpeed = 10.0;

Result<void> checkConfig(const NavigatorTournamentConfig& config) {
  if (config.suite == ComparisonConfig{}.suite) {  // the suite of the comparison with Jung & Lee (2015)
    return fail(
        ErrorCode::kUsage,
        fmt::format("--suite: '{}' is a comparison of several suites; a tournament takes one", config.suite));
  }
  if (config.speed && !(*config.speed >= kLeastSpeed && *config.speed <= kMostSpeed)) {
    return fail(ErrorCode::kUsage,
                fmt::format("--speed: {} is outside {} ... {} m/s", *config.speed, kLeastSpeed, kMostSpeed));
  }
  return {};
}

Result<void> checkNavigators(const std::vector<NavigatorChoice>& navigators) {
  if (navigators.size() < 2) return fail(ErrorCode::kUsage, "a tournament takes at least two navigators");
  for (std::size_t i = 0; i < navigators.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (navigators[i].text == navigators[j].text) {
        return fail(ErrorCode::kUsage, fmt::format("navigator '{}' is named twice", navigators[i].text));
      }
    }
  }
  return {};
}

Result<ComparisonConfig> comparisonOf(const NavigatorTournamentConfig& config) {
  const auto suite = findSuite(config.suite);
  if (!suite) return tl::unexpected<Error>(suite.error());
  ComparisonConfig comparison;
  comparison.suite = config.suite;
  comparison.navigators = config.navigators;
  comparison.speeds = {config.speed.value_or((*suite)->speeds.front())};
  comparison.trials = config.trials;
  comparison.seed = config.seed;
  comparison.jobs = config.jobs;
  comparison.robot = config.robot;
  comparison.physics = config.physics;
  comparison.sensors = config.sensors;
  comparison.pictures = 0;
  return comparison;
}

LayoutRuns runsOf(const Comparison& comparison) {
  LayoutRuns runs(comparison.blocks.front().navigators.size());
  for (std::size_t n = 0; n < runs.size(); ++n) {
    for (const TrialRecord& record : recordsOf(comparison, 0, n)) {
      runs[n].push_back({record.score.success(), record.score.time, record.score.length});
    }
  }
  return runs;
}

}  // namespace

Result<Comparison> planNavigatorTournament(const NavigatorTournamentConfig& config) {
  if (auto checked = checkConfig(config); !checked) return tl::unexpected<Error>(checked.error());
  const auto comparison = comparisonOf(config);
  if (!comparison) return tl::unexpected<Error>(comparison.error());
  auto plan = planComparison(*comparison);
  if (!plan) return plan;
  if (auto checked = checkNavigators(plan->blocks.front().navigators); !checked) {
    return tl::unexpected<Error>(checked.error());
  }
  return plan;
}

Result<NavigatorTournament> runNavigatorTournament(const NavigatorTournamentConfig& config,
                                                   const Progress& progress) {
  auto plan = planNavigatorTournament(config);
  if (!plan) return tl::unexpected<Error>(plan.error());
  NavigatorTournament tournament;
  tournament.comparison = std::move(*plan);
  // Runs without a clock, because measured times would differ between runs.
  if (auto ran = runComparison(tournament.comparison, {}, progress); !ran) {
    return tl::unexpected<Error>(ran.error());
  }
  tournament.tie = tournament.comparison.physics.controlPeriod();
  tournament.table = navigatorTable(runsOf(tournament.comparison), tournament.tie, config.seed);
  return tournament;
}

}  // namespace fulbito
