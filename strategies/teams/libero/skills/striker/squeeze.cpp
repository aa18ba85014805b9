#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

/// A robot whose face leans into the wall squeezes the ball along it. A robot that drives round the ball
/// would only hold it there. The point that it drives at is the place of a robot that holds the ball from the
/// other side. A nearer one presses the ball into the wall; with a farther one, the ball slips out between
/// the wall and the robot. A squeeze only holds a ball that no longer moves, and one in the own half that
/// slips out is behind the robot. There, and where robots cannot shove, `race` loosens more balls.
std::optional<Move> squeeze(const Picture& picture, int robot, Memory& memory) {
  const Pitch& pitch = picture.pitch;
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  const BallState& ball = picture.ball.now();
  if (!pitch.shoves || ball.position.x < 0.0 || picture.stuck > picture.tuning.jam_time ||
      !isPressed(picture, robot, aim))
    return std::nullopt;
  const Vec2 place = picture.ballFrom(robot) + aim.direction * pitch.around;
  return Move{.twist = alongHeading(pitch, picture.own(robot), math::angleOf(place), pitch.speed),
              .reason = "an opponent fights for it at a wall",
              .ball = ball.position};
}

}  // namespace fulbito::libero::striker
