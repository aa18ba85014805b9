#pragma once

#include <span>
#include <string>
#include <vector>

#include "fulbito/match.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Names of the terms of a reward, in the order in which they are written.
std::vector<std::string> termsOf(RewardForm form);

/// What one tick brought to one agent.
struct RewardTick {
  double gained = 0.0;  ///< of the ball's potential, as its team has it
  double nearer = 0.0;  ///< [m] by which robot and ball came closer
  WheelSpeeds wheels;   ///< [rad/s] applied command
  int goals = 0;        ///< of its team, less those against it
  int fouls = 0;        ///< called against its team
  double dt = 0.0;      ///< [s]
};

/// Adds the terms of RewardForm::kShaped of a tick.
/// @param top_wheel  [rad/s] unit of `energy`
void addShaped(const RewardTick& tick, const RewardWeights& weights, double top_wheel,
               std::span<double> terms);

/// The ball's potential: its distance from the goal at -x less that from the goal at +x, over twice the
/// distance between them; -0.5 in the one, 0.5 in the other.
double ballPotential(const FieldGeometry& field, Vec2 ball);

}  // namespace fulbito
