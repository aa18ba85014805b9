#include "strategies/skills/dribbling.hpp"

namespace fulbito {

bool opponentDribblesAtGoal(const Observation& seen, const BallState& ball) {
  constexpr double kSlowest = 0.3;  // [m/s] toward the own goal
  constexpr double kAtBall = 0.11;  // [m] between the centres of ball and opponent
  if (ball.velocity.x > -kSlowest) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    if (!seen.opponents[i].present) continue;
    const Vec2 rel = seen.opponents[i].state.pose.position - ball.position;
    if (squaredNorm(rel) < kAtBall * kAtBall && dot(rel, ball.velocity) < 0.0) return true;
  }
  return false;
}

}  // namespace fulbito
