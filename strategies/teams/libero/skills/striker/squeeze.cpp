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
  // The point is the place of a robot that holds the ball from the other side. A nearer one presses the ball
  // into the wall; with a farther one, the ball slips out between the wall and the robot. In their half,
  // where it cannot push the opponent away, it presses the ball into the wall until the free ball, which is
  // worth more than the slow way along the wall.
  const bool holds = !pitch.shoves && picture.ball.now().position.x > pitch.stuck_radius;
  const double heading = math::angleOf(holds ? rel : rel + aim.direction * pitch.around);
  return Move{.twist = alongHeading(picture.pitch, picture.own(robot), heading, picture.pitch.speed),
              .reason = "an opponent fights for it at a wall",
              .ball = picture.ball.now().position};
}

}  // namespace fulbito::libero::striker
