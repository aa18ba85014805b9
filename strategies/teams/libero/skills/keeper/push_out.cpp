#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Whether an opponent can reach the ball within `time` [s].
bool opponentArrives(const Picture& picture, double time) {
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i) &&
        timeToReach(picture.pitch.pace, picture.opponent(i), picture.ball.now().position) < time)
      return true;
  }
  return false;
}

}  // namespace

/// A keeper that waits would be pushed in with the ball by the next opponent that runs at it.
std::optional<Move> pushOut(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kIn = 0.02;      // [m] greatest distance of the keeper's centre in front of the goal line
  constexpr double kBefore = 0.03;  // [m] by which the ball must be farther out than the keeper
  constexpr double kAside = 0.06;   // [m]
  constexpr double kNear = 0.115;   // [m]
  constexpr double kLies = 0.35;    // [m/s]
  constexpr double kInTime = 0.2;   // [s] in which no opponent can reach the ball
  // [rad] heading error from straight out below which the keeper continues in any case
  constexpr double kTurned = 0.9;
  constexpr double kOut = 0.2;  // tangent of the turn toward the near post
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& ball = picture.ball.now();
  const Vec2 rel = picture.ballFrom(robot);
  if (self.pose.position.x > -pitch.half_length + kIn || std::abs(ball.position.y) > pitch.goal_half)
    return std::nullopt;
  if (rel.x < kBefore || std::abs(rel.y) > kAside || squaredNorm(rel) > kNear * kNear) return std::nullopt;
  if (std::abs(foldedError(0.0, self.pose.heading)) > kTurned &&
      (squaredNorm(ball.velocity) > kLies * kLies || opponentArrives(picture, kInTime)))
    return std::nullopt;
  const double side = ball.position.y >= 0.0 ? kOut : -kOut;
  const double heading = math::angleOf(unitOr(rel, {1.0, 0.0}) + Vec2{0.0, side});
  return Move{.twist = alongHeading(pitch, self, heading, pitch.speed),
              .reason = "the keeper was pushed into the goal",
              .ball = ball.position};
}

}  // namespace fulbito::libero::keeper
