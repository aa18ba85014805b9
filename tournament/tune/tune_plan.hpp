#pragma once

#include <string>

#include "fulbito/strategy.hpp"
#include "tournament/formats/schedule.hpp"
#include "tournament/plan/plan.hpp"
#include "tournament/tune/spsa.hpp"
#include "tournament/tune/tuned_team.hpp"

namespace fulbito {

/// Everything that determines the path of a tuning.
struct TunePlan {
  TunedTeam team;
  Spsa spsa;
  int final_pairs = 200;  ///< pairs of each final match-up; 0: no final match-ups
  /// The plan that all iterations share, of format match. Its first entrant is the team at the start values;
  /// its second one is the opponent, or the team again if there is none. `pairs` is the number per iteration.
  TournamentPlan base;
  bool opponent = false;  ///< true: both versions meet the second entrant; false: they meet each other
};

/// Checks everything except the teams. Errors: kUsage.
Result<void> validate(const TunePlan& plan);

/// The plan of one iteration, from 1. Its versions at `point` play `pairs` pairs, on starts that no other
/// iteration uses. They meet each other (fixtures 0 : 1), or both meet the opponent on the same starts
/// (fixtures 0 : 1 and 0 : 2). Errors: of the versions as `TeamCatalogue::parse`.
Result<TournamentPlan> iterationPlan(const TunePlan& plan, const TeamCatalogue& teams, const TunePoint& point,
                                     int iteration);

/// The result of an iteration as `nextPoint` takes it, from all its pairs.
double iterationResult(const TunePlan& plan, const Schedule& schedule, ResultsView results);

/// A final match-up, which measures what a tuning gained.
struct FinalPlan {
  std::string first, second;  ///< "tuned", "start" or "opponent"
  TournamentPlan plan;        ///< of format match
};

/// The tuned team at `point` against the team at the start values; with an opponent, also both against it.
/// All play the same starts, which no iteration uses. Empty if the plan has no final pairs. Errors: as
/// `iterationPlan`.
Result<std::vector<FinalPlan>> finalPlans(const TunePlan& plan, const TeamCatalogue& teams,
                                          const TunePoint& point);

}  // namespace fulbito
