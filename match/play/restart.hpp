// Private header of match: not installed.
#pragma once

#include <vector>

#include "engine/core/math/random.hpp"
#include "engine/sim/world.hpp"
#include "match/config/match_config.hpp"
#include "referee/match/match_referee.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "strategies/interface/strategy.hpp"

namespace fulbito {

/// The world of a new play and whose robots it has.
struct Play {
  RestartCall call;
  Placement placement;
  std::vector<RobotId> ids;
  World world;
  std::vector<GameEvent> events;  ///< of the restart itself, such as repaired placements
};

/// Asks the teams where they want to stand, in the order of the rule, and has the referee legalise it. The
/// call's ball is where the taking team wants it, if it has a choice.
Placement placementOf(RestartCall& call, const MatchReferee& referee, PerTeam<Strategy*> teams,
                      std::vector<GameEvent>& events);

/// Moves and turns every robot a little, as nobody places one exactly; a robot that the rule leaves no room
/// for it stays as it was, and so does one that nobody has touched.
void misplace(Placement& placement, const RestartCall& call, const MatchReferee& referee,
              const PlacementError& error, Rng& random);

/// The world that a placement makes. Errors: as `World::create`.
Result<Play> makePlay(const MatchConfig& config, const RestartCall& call, const Placement& placement);

}  // namespace fulbito
