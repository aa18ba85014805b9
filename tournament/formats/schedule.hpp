#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tournament/plan/plan.hpp"
#include "tournament/results/results.hpp"

namespace fulbito {

/// The fixtures of a tournament known so far. The index of a fixture is its number; fixtures are only ever
/// appended, so numbers stay valid.
struct Schedule {
  std::vector<Fixture> fixtures;
  bool complete = false;  ///< true: no more fixtures follow, whatever the results
};

/// Results by fixture number. Shorter than the schedule, or with gaps, while results are missing.
using FixtureResults = std::vector<std::optional<PairResult>>;

/// Results of the first fixtures.
using ResultsView = std::span<const std::optional<PairResult>>;

/// The fixtures that follow from the results so far: a pure function of a plan that `validateFormat` accepts.
/// Formats whose rounds depend on results (knock-out, Swiss, ladder) add a round once all fixtures before it
/// have results. A sequential test does not shorten the schedule.
Schedule scheduleOf(const TournamentPlan& plan, const FixtureResults& results);

/// Rounds of a Swiss tournament or ladder: the plan's number, or else as many as the format needs.
int roundsOf(const TournamentPlan& plan);

/// The groups of a round robin, each in order of seeding. Entrants are dealt in serpentine order: to groups
/// 0, 1, 2, 2, 1, 0, 0, 1 ...
std::vector<std::vector<std::size_t>> groupsOf(const TournamentPlan& plan);

/// The largest number of fixtures that the tournament can have.
std::int64_t mostFixtures(const TournamentPlan& plan);

/// Checks the numbers of entrants, pairs, rounds and groups for the format. Errors: kUsage naming the key.
Result<void> validateFormat(const TournamentPlan& plan);

}  // namespace fulbito
