#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"
#include "referee/calls/note_presence.hpp"
#include "referee/geometry/ball_gap.hpp"

namespace fulbito {

std::optional<Finding> detectKeeperHolding(const DetectorInput& in, const PresenceMemory& presence,
                                           KeeperMemory& memory) {
  const KeeperRules& rules = in.setup.rules.keeper;
  const Side side = halfOf(in.view.ball.position);
  const TeamId team = defenderOf(in.state, side);
  memory.control[indexOf(other(team))] = {};
  Spell& control = memory.control[indexOf(team)];
  const auto keeper = keeperOf(in, team, presence);
  if (!rules.holding || !at(in.areas, side).ball || !keeper || !keepsGoal(in, *keeper, presence)) {
    control = {};
    return std::nullopt;
  }
  // A challenge ends the count even while the keeper has lost the ball for a moment.
  if (disputes(in, other(team), rules.dispute_lengths)) {
    control = {};
    return std::nullopt;
  }
  if (!ballGap(in.setup.robot, in.view.robots[*keeper].pose, in.setup.ball, in.view.ball.position,
               rules.control_gap)) {
    return std::nullopt;
  }
  control.add(in.view.tick, ticksOf(rules.release_seconds, in.setup.dt));
  const Tick ticks = control.ticks(in.view.tick);
  if (ticks <= ticksOf(rules.hold_seconds, in.setup.dt)) return std::nullopt;
  if (!cooledDown(in, rules.cool_down)) return std::nullopt;
  Finding call = makeFinding(in, clause::kKeeperHolds, "8.1", RestartKind::kPenalty, other(team));
  blame(call, in.view.ids[*keeper]);
  measureTicks(in, call, ticks, rules.hold_seconds);
  return call;
}

}  // namespace fulbito
