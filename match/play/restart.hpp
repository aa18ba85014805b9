#pragma once

#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/world.hpp"
#include "referee/match/match_referee.hpp"
#include "referee/restarts/restart_placement.hpp"

namespace fulbito {

/// The world of a new play and its robots.
struct Play {
  RestartCall call;
  Placement placement;
  std::vector<RobotId> ids;
  World world;
  std::vector<GameEvent> events;  ///< of the restart itself, such as repaired placements
};

/// The placement of one restart, team by team in the order of the rule. A plain value.
class Placing {
 public:
  /// @param cause the call that stopped play; without a clause at the start of the match
  Placing(const RestartCall& call, const GameEvent& cause) : call_(call), cause_(cause), first_(call.team) {}

  /// The team that proposes its placement next; empty once both have.
  std::optional<TeamId> asked() const;
  /// The request to that team, without `now`.
  PlacementRequest request(const MatchReferee& referee) const;
  /// Takes that team's proposal; empty: it has no wishes. The taking team's wish moves the ball of the call,
  /// if the rule allows it.
  void answer(const std::optional<TeamProposal>& proposal, const MatchReferee& referee);
  /// The placement by the proposals so far, after the referee's repairs; appends the repairs to `events`.
  Placement legalised(const MatchReferee& referee, std::vector<GameEvent>& events) const;

  /// The restart, with the ball as proposed.
  const RestartCall& call() const { return call_; }
  /// [s] from the placement to the signal.
  double delay(const MatchReferee& referee) const;

 private:
  RestartCall call_;
  GameEvent cause_;
  TeamId first_;
  std::size_t answers_ = 0;
  Proposals proposals_;
  std::vector<GameEvent> repairs_;  ///< repairs of the ball's place
};

/// Adds the placement error to each robot's pose. A robot without room for it within the rule keeps its pose,
/// and so does a robot that the restart does not move.
void misplace(Placement& placement, const RestartCall& call, const MatchReferee& referee,
              const PlacementError& error, Rng& random);

/// Creates the world of a placement. Errors: as `World::create`.
Result<Play> makePlay(const MatchConfig& config, const RestartCall& call, const Placement& placement);

}  // namespace fulbito
