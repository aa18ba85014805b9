#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

/// A robot whose face leans into the wall squeezes the ball along it. A robot that drives round the ball
/// would only hold it there.
std::optional<Move> squeeze(const Picture& picture, int robot, Memory& memory) {
  const Pitch& pitch = picture.pitch;
  const double reach = pitch.touch + pitch.front;
  const Vec2 rel = picture.ballFrom(robot);
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  if (squaredNorm(rel) >= reach * reach ||
      !isFoughtFor(picture, rel, aim, picture.tuning.pushable, picture.tuning.rival_near))
    return std::nullopt;
  // A point farther along the wall moves the ball round the corner sooner. But a ball that two opponents
  // bring down the end wall then slips between that wall and the robot.
  const double heading = math::angleOf(rel + aim.direction * pitch.front);
  return Move{.twist = alongHeading(picture.pitch, picture.own(robot), heading, picture.pitch.speed),
              .reason = "an opponent fights for it at a wall",
              .ball = picture.ball.now().position};
}

}  // namespace fulbito::libero::striker
