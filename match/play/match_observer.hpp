#pragma once

#include <span>

#include "engine/sim/world.hpp"
#include "match/config/match_config.hpp"
#include "referee/match/match_referee.hpp"
#include "strategies/interface/team_command.hpp"

namespace fulbito {

/// One tick of play as it happened. Views stay valid during the call only.
struct MatchTick {
  Tick tick = 0;                          ///< of the match, after the step
  std::span<const RobotId> ids;           ///< of the robots on the field
  std::span<const WheelSpeeds> commands;  ///< that were applied, rounded, in the order of `ids`
  const WorldState* world = nullptr;      ///< after the step
  std::span<const ContactEvent> contacts;
  std::span<const GameEvent> events;  ///< of this tick
  const RefereeState* referee = nullptr;
  PerTeam<const TeamCommand*> decisions{};  ///< that were carried out, each in its team's frame
  /// What the teams' navigators wanted, as their decisions; empty unless somebody `wantsDrawings`.
  PerTeam<std::span<const DebugDrawing>> ways{};
  std::uint64_t hash = 0;  ///< over the states of all ticks so far: `Match::hash`
};

/// The beginning of a play: a new world from a placed state.
struct PlayStart {
  Tick tick = 0;                 ///< of the match
  RestartCall call;              ///< how play begins
  Placement placement;           ///< where all stand after repairs
  std::span<const RobotId> ids;  ///< of the world's robots
  const WorldConfig* world = nullptr;
  std::span<const GameEvent> events;  ///< of the restart itself, such as repaired placements
  const RefereeState* referee = nullptr;
  bool edited = false;  ///< placed by a user in the middle of the match: `Match::replace`
};

/// Something that watches a match: a recorder, statistics, an event stream. The match's result never depends
/// on who watches.
class MatchObserver {
 public:
  virtual ~MatchObserver() = default;
  virtual void matchBegins(const MatchConfig&) {}
  virtual void playBegins(const PlayStart&) {}
  virtual void ticked(const MatchTick&) {}
  /// The match cannot go on after this tick: the event says when, `Match::faults` why. `matchEnds` follows.
  virtual void abandoned(const GameEvent&, const RefereeState&) {}
  virtual void matchEnds(const RefereeState&, Tick) {}
  /// Whether what the teams draw in the step that leads to `tick` will be looked at. Teams are asked to draw
  /// for no other.
  virtual bool wantsDrawings(Tick) const { return false; }
};

}  // namespace fulbito
