#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

/// A robot whose face leans into the wall squeezes the ball along it. A robot that drives round the ball
/// would only hold it there.
std::optional<Move> squeeze(const Picture& picture, int robot, Memory& memory) {
  constexpr double kReach = 0.13;  // [m]
  constexpr double kRolls = 0.8;   // [m/s] a faster ball cannot be pushed
  constexpr double kRival = 0.20;  // [m] an opponent farther from the ball leaves time to drive round it
  // [m] aim point along the wall in front of the ball. A larger value moves the ball round the corner sooner.
  // But a ball that two opponents bring down the end wall then slips between that wall and the robot.
  constexpr double kAlong = 0.06;
  const Vec2 rel = picture.ballFrom(robot);
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  if (squaredNorm(rel) >= kReach * kReach || !isFoughtFor(picture, rel, aim, kRolls, kRival))
    return std::nullopt;
  const double heading = math::angleOf(rel + aim.direction * kAlong);
  return Move{.twist = alongHeading(picture.own(robot), heading, picture.pitch.speed),
              .reason = "an opponent fights for it at a wall",
              .ball = picture.ball.now().position};
}

}  // namespace fulbito::libero::striker
