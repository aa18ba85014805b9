#pragma once

#include <string>

#include "fulbito/strategy.hpp"
#include "tournament/formats/schedule.hpp"
#include "tournament/plan/plan.hpp"
#include "tournament/tune/spsa.hpp"
#include "tournament/tune/tuned_team.hpp"

namespace fulbito {

/// A tuning: everything that determines its path. A plain value.
struct TunePlan {
  TunedTeam team;
  Spsa spsa;
  int final_pairs = 200;  ///< of each final match-up; 0: none
  /// What all matches share: a plan of format match whose first entrant is the team at the start and whose
  /// second one is the opponent, if there is one, otherwise the team again. `pairs` are those per iteration.
  TournamentPlan base;
  bool opponent = false;  ///< both versions meet the second entrant; otherwise they meet each other
};

/// Checks all but the teams. Errors: kUsage.
Result<void> validate(const TunePlan& plan);

/// The plan of one iteration, 1 ...: its versions at `point` play `pairs` pairs, on starts that no other
/// iteration has: against each other (fixtures 0 : 1), or both against the opponent on the same starts
/// (fixtures 0 : 1 and 0 : 2). Errors: of the versions as `TeamCatalogue::parse`.
Result<TournamentPlan> iterationPlan(const TunePlan& plan, const TeamCatalogue& teams, const TunePoint& point,
                                     int iteration);

/// The result of an iteration for `nextPoint`, from all its pairs.
double iterationResult(const TunePlan& plan, const Schedule& schedule, ResultsView results);

/// A match-up that shows what a tuning is worth.
struct FinalPlan {
  std::string first, second;  ///< "tuned", "start" or "opponent"
  TournamentPlan plan;        ///< of format match
};

/// The tuned team at `point` against that of the start; with an opponent, both against it too. All play the
/// same starts, which no iteration has. None if the plan has no final pairs. Errors: as `iterationPlan`.
Result<std::vector<FinalPlan>> finalPlans(const TunePlan& plan, const TeamCatalogue& teams,
                                          const TunePoint& point);

}  // namespace fulbito
