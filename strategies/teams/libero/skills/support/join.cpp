#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {
namespace {

/// How many supports may join. In a large match, opponents come in threes and fours, too.
int mostJoining(const Pitch& pitch) { return pitch.isLarge() ? 2 : 1; }

}  // namespace

/// Two robots that push in one direction win a ball that one alone could only hold. Where two cannot move an
/// opponent, the second one is worth more elsewhere, but for matches with many robots. The same holds for
/// the open field of a small match. One ahead of the ball would be in the striker's way.
std::optional<Move> join(const Picture& picture, int robot, Memory& memory) {
  const BallState& ball = picture.ball.now();
  const Tuning& tuning = picture.tuning;
  const bool helps = picture.pitch.shoves || picture.pitch.isLarge();
  if (!helps || picture.rank[static_cast<std::size_t>(robot)] >= mostJoining(picture.pitch) ||
      picture.own(robot).pose.position.x > ball.position.x ||
      squaredNorm(ball.velocity) > tuning.pushable * tuning.pushable ||
      picture.opponentsNear(ball.position, tuning.rival_far) == 0)
    return std::nullopt;
  // The wall comes first, because the search for an aim takes longer.
  if (!picture.pitch.isLarge() &&
      (!isAtWall(picture.pitch, shotBall(picture, robot)) || !shotOf(picture, robot, memory.shot).aim.wall))
    return std::nullopt;
  auto move = striker::squeeze(picture, robot, memory);
  if (!move) move = striker::strike(picture, robot, memory);
  move->reason = "an opponent fights for the ball";
  return move;
}

}  // namespace fulbito::libero::support
