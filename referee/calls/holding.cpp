#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"
#include "referee/calls/note_presence.hpp"

namespace fulbito {
namespace {

bool ballAtWall(const MatchView& view) {
  return std::any_of(view.contacts.begin(), view.contacts.end(), [](const ContactEvent& contact) {
    return contact.a.kind == BodyKind::kWall && contact.b.kind == BodyKind::kBall;
  });
}

/// Whether the robot pins the ball: robot presses ball, ball presses wall, both nearly at rest.
bool pins(const DetectorInput& in, std::size_t i) {
  const double most = in.setup.rules.fouls.pinned_speed * in.setup.rules.fouls.pinned_speed;
  return squaredNorm(in.view.ball.velocity) <= most && squaredNorm(in.view.robots[i].velocity) <= most &&
         !disputes(in, other(in.view.ids[i].team), in.setup.rules.fouls.dispute_lengths);
}

Finding callOf(const DetectorInput& in, std::size_t i, Tick ticks) {
  const RobotId robot = in.view.ids[i];
  const bool in_own_area = at(in.areas, in.state.sideOf(robot.team)).ball;
  Finding call =
      in_own_area
          ? makeFinding(in, clause::kPenaltyHolding, "8.1", RestartKind::kPenalty, other(robot.team))
          : makeFinding(in, clause::kFreeKickHolding, "8.1", RestartKind::kFreeKick, other(robot.team));
  blame(call, robot);
  measureTicks(in, call, ticks, in.setup.rules.fouls.pinned_seconds);
  return call;
}

}  // namespace

std::optional<Finding> detectHolding(const DetectorInput& in, const PresenceMemory& presence,
                                     FoulMemory& memory) {
  const FoulRules& rules = in.setup.rules.fouls;
  if (!rules.holding || !cooledDown(in, rules.cool_down) || !ballAtWall(in.view)) return std::nullopt;
  for (const ContactEvent& contact : in.view.contacts) {
    if (!isRobot(contact.a, in.view) || contact.b.kind != BodyKind::kBall) continue;
    const std::size_t i = contact.a.index;
    if (keepsGoal(in, i, presence) || !pins(in, i)) continue;
    Spell& spell = memory.pinned[i];
    spell.add(in.view.tick, ticksOf(rules.holding_release, in.setup.dt));
    const Tick ticks = spell.ticks(in.view.tick);
    if (ticks > ticksOf(rules.pinned_seconds, in.setup.dt)) return callOf(in, i, ticks);
  }
  return std::nullopt;
}

}  // namespace fulbito
