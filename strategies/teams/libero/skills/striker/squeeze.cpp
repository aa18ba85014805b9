#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether the robot holds the ball until the free ball. In their half, where it cannot push the opponent
/// away, a free ball is worth more than the slow way along the wall. But some rules give none for minutes, in
/// which even a ball that creeps a circle's radius in each `patience` comes to their end. Some matches have
/// no referee.
bool holds(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const double patience = picture.tuning.patience;
  return !pitch.shoves && picture.ball.now().position.x > pitch.stuck_radius &&
         pitch.stuck_time * pitch.stuck_radius < pitch.half_length * patience &&
         picture.stuck < pitch.stuck_time + patience;
}

/// Leans on the ball. The point is the place of a robot that holds the ball from the other side. A nearer one
/// presses the ball into the wall; with a farther one, the ball slips out between the wall and the robot.
/// Robots that cannot shove creep. They push along the wall, toward two robots in a row behind that place.
Twist push(const Picture& picture, const RobotState& self, Vec2 rel, Vec2 along) {
  const Pitch& pitch = picture.pitch;
  const double far = pitch.shoves ? pitch.around : pitch.around + 2 * pitch.bodies;
  return alongHeading(pitch, self, math::angleOf(rel + along * far), pitch.speed);
}

}  // namespace

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
  const RobotState& self = picture.own(robot);
  // A robot that pushed on would creep out of the circle in which a ball counts as stuck.
  const bool keeps = holds(picture);
  return Move{.twist = keeps ? holdBall(picture, robot) : push(picture, self, rel, aim.direction),
              .reason = keeps ? "it is held for the free ball" : "an opponent fights for it at a wall",
              .ball = picture.ball.now().position};
}

}  // namespace fulbito::libero::striker
