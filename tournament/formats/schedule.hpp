#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tournament/plan/plan.hpp"
#include "tournament/results/results.hpp"

namespace fulbito {

/// What is known of the fixtures of a tournament. A fixture's place in the list is its number; the list only
/// ever grows, so numbers stay.
struct Schedule {
  std::vector<Fixture> fixtures;
  bool complete = false;  ///< no fixture follows, whatever the results
};

/// Results by number of the fixture; shorter than the schedule or with gaps while matches are missing.
using FixtureResults = std::vector<std::optional<PairResult>>;

/// Some of the first of them.
using ResultsView = std::span<const std::optional<PairResult>>;

/// The fixtures that follow from the results so far: a pure function of a plan that `validateFormat` accepts.
/// Formats whose rounds depend on results (knock-out, Swiss, ladder) add a round once all fixtures before it
/// have results. A sequential test does not shorten the schedule.
Schedule scheduleOf(const TournamentPlan& plan, const FixtureResults& results);

/// Rounds of a Swiss tournament or ladder: those that the plan names, otherwise as many as the format needs.
int roundsOf(const TournamentPlan& plan);

/// The groups of a round robin, each in order of seeding. Entrants are dealt in serpentine order: to groups
/// 0, 1, 2, 2, 1, 0, 0, 1 ...
std::vector<std::vector<std::size_t>> groupsOf(const TournamentPlan& plan);

/// The number of fixtures that a tournament has at most.
std::int64_t mostFixtures(const TournamentPlan& plan);

/// Checks numbers of entrants, pairs, rounds and groups for the format. Errors: kUsage naming the key.
Result<void> validateFormat(const TournamentPlan& plan);

}  // namespace fulbito
