#include <algorithm>
#include <cmath>

#include "strategies/skills/dribbling.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Offset [m] of the keeper from the crossing of a ball that an opponent pushes, toward the side from which
/// the ball comes. So the keeper already moves with the ball at the touch. A ball slides along the face of a
/// keeper that stands still and passes it.
double lead(const Picture& picture, double line) {
  if (!opponentDribblesAtGoal(picture.seen, picture.ball.now())) return 0.0;
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double gap = ball.position.x - (line + pitch.front);
  const double time = std::clamp(gap / -ball.velocity.x, 0.0, pitch.turn_time);
  return -picture.tuning.keeper_share * ball.velocity.y * time;
}

}  // namespace

std::optional<Move> standInGoal(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const double line = keeperLine(pitch);
  const auto shot = shotAtKeeper(picture);
  const double y = shot ? withinMouth(pitch, *shot + lead(picture, line)) : readyPlace(picture);
  return Move{.twist = slideTo(picture, picture.own(robot), line, y),
              .reason = shot ? "the ball will cross the line there" : "ready for both posts",
              .place = Vec2{line, y}};
}

}  // namespace fulbito::libero::keeper
