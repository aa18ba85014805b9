#include "python/environments/match/rewards.hpp"

#include <cmath>

namespace fulbito {

std::vector<std::string> termsOf(RewardForm form) {
  if (form == RewardForm::kCompat) return {"goal", "move", "ball_grad", "energy"};
  return {"goal", "ball", "move", "energy", "foul"};
}

double ballPotential(const FieldGeometry& field, Vec2 ball) {
  const Vec2 goal{field.length / 2, 0.0};
  return (distance(ball, -goal) - distance(ball, goal)) / (2.0 * field.length);
}

void addShaped(const RewardTick& tick, const RewardWeights& weights, double top_wheel,
               std::span<double> terms) {
  const double driven = (std::abs(tick.wheels.left) + std::abs(tick.wheels.right)) / (2.0 * top_wheel);
  terms[0] += weights.goal * tick.goals;
  terms[1] += weights.ball * tick.gained;
  terms[2] += weights.move * tick.nearer;
  terms[3] -= weights.energy * driven * tick.dt;
  terms[4] -= weights.foul * tick.fouls;
}

}  // namespace fulbito
