#pragma once

#include "engine/core/base/result.hpp"

namespace fulbito {

/// A ball on a flat floor. After a kick it slides, its spin catches up, then it rolls and slowly loses speed.
/// Defaults: the golf ball of the league as measured (docs/models.md).
struct BallModel {
  double radius = 0.0215;  ///< [m]
  double mass = 0.056;     ///< [kg] effective in impacts: the ratio to the robot's mass is what was measured
  double roll_keep =
      0.70;  ///< share of the speed left when sliding has turned into rolling (5/7 for a solid ball)
  double slide_deceleration = 3.0;  ///< [m/s^2] while sliding
  double roll_deceleration = 0.14;  ///< [m/s^2] while rolling
  double stop_speed = 0.01;         ///< [m/s] below this a rolling ball rests
  double wall_restitution = 0.50;   ///< speed kept along the normal at a wall, before the spin settles
  double wall_spin_keep = 0.306;    ///< share of the spin along the normal that survives an impact
  double robot_restitution = 0.04;  ///< against robots and obstacles
  double friction = 0.1;            ///< against everything
};

/// Checks ranges; the error names the key.
Result<void> validate(const BallModel& ball);

}  // namespace fulbito
