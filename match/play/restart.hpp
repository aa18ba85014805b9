#pragma once

#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/world.hpp"
#include "referee/match/match_referee.hpp"
#include "referee/restarts/restart_placement.hpp"

namespace fulbito {

/// The world of a new play and whose robots it has.
struct Play {
  RestartCall call;
  Placement placement;
  std::vector<RobotId> ids;
  World world;
  std::vector<GameEvent> events;  ///< of the restart itself, such as repaired placements
};

/// The placing of one restart, team by team in the order of the rule. A plain value.
class Placing {
 public:
  /// @param cause what stopped play; without a clause: nothing, the match begins
  Placing(const RestartCall& call, const GameEvent& cause) : call_(call), cause_(cause), first_(call.team) {}

  /// The team that is to say where it wants to stand; empty once both have.
  std::optional<TeamId> asked() const;
  /// What it is told, all but `now`.
  PlacementRequest request(const MatchReferee& referee) const;
  /// Takes what it says; empty: it has no wishes. The ball of the call goes where the taking team wants it,
  /// if the rule gives it a choice.
  void answer(const std::optional<TeamProposal>& proposal, const MatchReferee& referee);
  /// Where all stand by the wishes so far, as the referee legalised them; `events` gets what it changed.
  Placement legalised(const MatchReferee& referee, std::vector<GameEvent>& events) const;

  const RestartCall& call() const { return call_; }
  /// [s] from the placement to the signal.
  double delay(const MatchReferee& referee) const;

 private:
  RestartCall call_;
  GameEvent cause_;
  TeamId first_;
  std::size_t answers_ = 0;
  Proposals proposals_;
  std::vector<GameEvent> repairs_;  ///< of the ball
};

/// Moves and turns every robot a little, as nobody places one exactly; a robot that the rule leaves no room
/// for it stays as it was, and so does one that nobody has touched.
void misplace(Placement& placement, const RestartCall& call, const MatchReferee& referee,
              const PlacementError& error, Rng& random);

/// The world that a placement makes. Errors: as `World::create`.
Result<Play> makePlay(const MatchConfig& config, const RestartCall& call, const Placement& placement);

}  // namespace fulbito
