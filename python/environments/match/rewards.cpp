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

void addShaped(const RewardTick& tick, const RewardWeights& weights, const FieldGeometry& field,
               const RobotModel& robot, std::span<double> terms) {
  const double gained = ballPotential(field, tick.ball_after) - ballPotential(field, tick.ball_before);
  const double nearer =
      distance(tick.robot_before, tick.ball_before) - distance(tick.robot_after, tick.ball_after);
  const double driven =
      (std::abs(tick.wheels.left) + std::abs(tick.wheels.right)) / (2.0 * robot.max_wheel_speed);
  terms[0] += weights.goal * tick.goals;
  terms[1] += weights.ball * gained;
  terms[2] += weights.move * nearer;
  terms[3] -= weights.energy * driven * tick.dt;
  terms[4] -= weights.foul * tick.fouls;
}

}  // namespace fulbito
