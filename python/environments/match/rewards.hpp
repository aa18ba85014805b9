#pragma once

#include <span>
#include <string>
#include <vector>

#include "fulbito/match.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Names of the terms of a reward, in the order in which they are written.
std::vector<std::string> termsOf(RewardForm form);

/// What one tick brought to one agent, in its team's frame.
struct RewardTick {
  Vec2 ball_before, ball_after;    ///< [m]
  Vec2 robot_before, robot_after;  ///< [m]
  WheelSpeeds wheels;              ///< [rad/s] applied command
  int goals = 0;                   ///< of the team, less those against it
  int fouls = 0;                   ///< called against the team
  double dt = 0.0;                 ///< [s]
};

/// Adds the terms of RewardForm::kShaped of a tick.
/// @param robot  its top wheel speed is the unit of `energy`
void addShaped(const RewardTick& tick, const RewardWeights& weights, const FieldGeometry& field,
               const RobotModel& robot, std::span<double> terms);

/// The ball's potential: its distance from the own goal less that from the opponents', over twice the
/// distance between the goals; -0.5 in the own goal, 0.5 in the opponents'.
double ballPotential(const FieldGeometry& field, Vec2 ball);

}  // namespace fulbito
