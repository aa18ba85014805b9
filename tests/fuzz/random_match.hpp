#pragma once

#include <map>
#include <string>

#include "fulbito/models.hpp"
#include "referee/match/match_referee.hpp"

namespace fulbito::test {

/// What a random match is made from.
struct RandomMatch {
  RefereeSetup setup;
  PhysicsProfile physics;
  double eager = 0.5;      ///< share of robots that chase the ball; the others drive anywhere
  double idle = 0.1;       ///< share of robots that stand still
  bool proposals = false;  ///< teams propose placements, good and bad
  Tick ticks = 0;          ///< at most
};

/// What came of it.
struct RandomMatchResult {
  std::string fault;  ///< the first broken promise; empty if there is none
  Tick ticks = 0;
  int restarts = 0;
  int repairs = 0;                              ///< proposals that had to be replaced
  Tick longest_stuck = 0;                       ///< ticks that the ball stayed at its place
  PerTeam<int> goals{};                         ///< by Side: of the goal scored in
  std::map<std::string, int> calls;             ///< by clause
  std::map<std::string, PerTeam<int>> awarded;  ///< by restart, by the Side that its taker defends
};

/// Plays random robots in a World under a MatchReferee and checks every tick: the score changes by goals
/// alone, a ball that stays where it is is called in time, every restart stands legally and without overlap,
/// nobody leaves the field, the match ends when its time is over.
RandomMatchResult playRandomMatch(const RandomMatch& match);

}  // namespace fulbito::test
