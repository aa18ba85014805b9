#pragma once

#include "engine/core/base/result.hpp"

namespace fulbito {

/// A ball on a flat floor. After a kick it slides until its spin catches up, then it rolls and slowly stops.
/// Defaults: the golf ball of the league as measured (docs/models.md).
struct BallModel {
  double radius = 0.0215;   ///< [m]
  double mass = 0.056;      ///< [kg] effective in impacts: the ratio to the robot's mass is measured
  double roll_keep = 0.70;  ///< share of the speed left when sliding becomes rolling (5/7 for a solid ball)
  double slide_deceleration = 3.0;  ///< [m/s^2] while sliding
  double roll_deceleration = 0.14;  ///< [m/s^2] while rolling
  double stop_speed = 0.01;         ///< [m/s] slower rolling balls stop
  double wall_restitution = 0.50;   ///< at a wall, along the normal, before friction changes the spin
  double wall_spin_keep = 0.306;    ///< share of the spin along the normal that survives an impact
  double robot_restitution = 0.04;  ///< against robots and obstacles
  double friction = 0.1;            ///< against everything
};

/// Checks ranges; the error names the key.
Result<void> validate(const BallModel& ball);

}  // namespace fulbito
