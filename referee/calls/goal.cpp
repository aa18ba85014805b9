#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

/// The scoring team's robot that touched the ball last, if that was recent enough.
std::optional<std::uint8_t> scorerOf(const DetectorInput& in, TeamId team, const TouchMemory& touches) {
  Tick last = in.view.tick - ticksOf(in.setup.rules.goal.scorer_seconds, in.setup.dt) - 1;
  std::optional<std::uint8_t> scorer;
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (in.view.ids[i].team != team || touches.ball[i] <= last) continue;
    last = touches.ball[i];
    scorer = in.view.ids[i].number;
  }
  return scorer;
}

}  // namespace

std::optional<Finding> detectGoal(const DetectorInput& in, const TouchMemory& touches) {
  const Vec2 ball = in.view.ball.position;
  const double beyond = std::abs(ball.x) - in.setup.field.length / 2;
  const double needed = in.setup.rules.goal.ball == BallPart::kWhole ? in.setup.ball.radius : 0.0;
  // Written so that a ball position that is not finite is no goal.
  if (!(beyond > needed) || !(std::abs(ball.y) < in.setup.field.goal_width / 2)) return std::nullopt;
  const TeamId conceded = defenderOf(in.state, halfOf(ball));
  Finding goal = makeFinding(in, clause::kGoal, "7.1", RestartKind::kKickOff, conceded);
  measure(goal, beyond, needed);
  goal.event.team = other(conceded);
  goal.event.robot = scorerOf(in, other(conceded), touches);
  return goal;
}

}  // namespace fulbito
