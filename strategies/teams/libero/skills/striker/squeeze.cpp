#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether a squeeze is still worth more than a push, which `race` makes. A squeeze holds a ball that does
/// not move. In the own half that keeps it from the own goal; in their half it gives opponents time to come
/// back. In a large match they are there already.
bool pays(const Picture& picture, const PressMemory& press) {
  if (picture.pitch.isLarge()) return false;
  const Tuning& tuning = picture.tuning;
  const bool ours = picture.ball.now().position.x < 0.0;
  return ours ? press.jammed <= tuning.patience : picture.stuck <= tuning.jam_time;
}

}  // namespace

/// A robot whose face leans into the wall squeezes the ball along it. A robot that drives round the ball
/// would only hold it there. The point that it drives at is the place of a robot that holds the ball from the
/// other side. A nearer one presses the ball into the wall; with a farther one, the ball slips out between
/// the wall and the robot. Where robots cannot shove, `race` loosens more balls.
std::optional<Move> squeeze(const Picture& picture, int robot, Memory& memory) {
  const Pitch& pitch = picture.pitch;
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  if (!pitch.shoves || !pays(picture, memory.press) || !isPressed(picture, robot, aim)) return std::nullopt;
  const Vec2 place = picture.ballFrom(robot) + aim.direction * pitch.around;
  return Move{.twist = alongHeading(pitch, picture.own(robot), math::angleOf(place), pitch.speed),
              .reason = "an opponent fights for it at a wall",
              .ball = picture.ball.now().position};
}

}  // namespace fulbito::libero::striker
