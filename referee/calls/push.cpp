#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

/// Whether the robot is away from the ball.
bool awayFromBall(const DetectorInput& in, std::size_t i, const TouchMemory& touches) {
  const FoulRules& rules = in.setup.rules.fouls;
  const Vec2 gap = in.view.robots[i].pose.position - in.view.ball.position;
  return squaredNorm(gap) > rules.push_distance * rules.push_distance &&
         !recent(in, touches.ball[i], rules.part_seconds);
}

/// The robot that pushes the other in this contact.
std::optional<std::size_t> pusherIn(const DetectorInput& in, const ContactEvent& contact,
                                    const TouchMemory& touches) {
  if (!isRobot(contact.a, in.view) || !isRobot(contact.b, in.view)) return std::nullopt;
  const std::size_t a = contact.a.index, b = contact.b.index;
  if (in.view.ids[a].team == in.view.ids[b].team) return std::nullopt;
  if (!awayFromBall(in, a, touches) || !awayFromBall(in, b, touches)) return std::nullopt;
  const double speed = in.setup.rules.fouls.push_speed;
  if (dot(in.view.robots[b].velocity, contact.normal) >= speed) return a;
  if (dot(in.view.robots[a].velocity, -contact.normal) >= speed) return b;
  return std::nullopt;
}

}  // namespace

std::optional<Finding> detectPush(const DetectorInput& in, const TouchMemory& touches, FoulMemory& memory) {
  const FoulRules& rules = in.setup.rules.fouls;
  if (!rules.push || !cooledDown(in, rules.cool_down)) return std::nullopt;
  for (const ContactEvent& contact : in.view.contacts) {
    const auto pusher = pusherIn(in, contact, touches);
    if (!pusher) continue;
    Spell& spell = memory.pushes[*pusher];
    spell.add(in.view.tick, ticksOf(rules.push_release, in.setup.dt), contact.impulse);
    if (spell.ticks(in.view.tick) < ticksOf(rules.push_seconds, in.setup.dt)) continue;
    if (spell.sum < rules.push_impulse) continue;
    const RobotId robot = in.view.ids[*pusher];
    Finding call = makeFinding(in, clause::kPush, "8.1", RestartKind::kFreeKick, other(robot.team));
    blame(call, robot);
    measure(call, spell.sum, rules.push_impulse);
    return call;
  }
  return std::nullopt;
}

}  // namespace fulbito
