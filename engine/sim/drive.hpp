// Private header of engine/sim: not installed.
#pragma once

#include <algorithm>

#include "engine/core/base/values.hpp"
#include "engine/core/models/drive_law.hpp"

namespace fulbito {

/// Motion of a robot's body in its own frame.
struct BodyMotion {
  double forward = 0.0;   ///< [m/s]
  double sideways = 0.0;  ///< [m/s] toward the left
  double yaw = 0.0;       ///< [rad/s] counter-clockwise
};

/// Yaw rate that a robot reaches spinning in place, over that of ideal wheels: linear in the rim speed
/// between the model's two measured points, constant outside; 1 where the model has none. Wheels that roll
/// the same way scrub less: the ratio fades from spinning in place to turning about a wheel.
class SpinRatio {
 public:
  explicit SpinRatio(const RobotModel& robot);
  /// @param rim_speed  [m/s] >= 0
  double at(double rim_speed) const { return slow_ + slope_ * std::clamp(rim_speed - from_, 0.0, span_); }

 private:
  double from_ = 0.0;  // [m/s]
  double span_ = 0.0;  // [m/s]
  double slow_ = 1.0;
  double slope_ = 0.0;  // [s/m]
};

/// Motors, wheels and tyres of one robot. The motors pull the rims toward the command by the `DriveLaw`; the
/// floor passes on no more than the tyre's grip, beyond which the wheel slips; across the wheels the tyres
/// resist up to their own limit (Coulomb).
class Drive {
 public:
  /// @param step_period   [s] one physics step
  /// @param command_step  [rad/s] commands are rounded to multiples of it; <= 0: not rounded
  Drive(const RobotModel& robot, double step_period, double command_step);

  /// Sets the wheel speeds to reach; NaN becomes 0, then saturated, then rounded.
  void setCommand(WheelSpeeds command);

  /// What motors and floor change in the body's motion during one physics step.
  BodyMotion step(const BodyMotion& motion);

  /// What the encoders read when the body then moves at `forward` [m/s] and `yaw` [rad/s]: the ground's
  /// speed, or the wheel's own while it slips [rad/s].
  WheelSpeeds encoders(double forward, double yaw) const;

 private:
  double rimTarget(double wheel_speed) const;
  double slippingLimit(double pull, double target, double ground, double& rim, bool& slips) const;

  DriveLaw law_;
  SpinRatio spin_ratio_;
  double max_wheel_speed_;
  double command_step_;      // [rad/s], 0: not rounded
  double per_command_step_;  // [s/rad]
  double radius_;            // [m]
  double half_track_;        // [m]
  double per_radius_;        // [1/m]
  double max_grip_;          // [m/s] in one step, along the wheels
  double max_lateral_;       // [m/s] in one step, across
  RimSpeeds target_;
  RimSpeeds rim_;  // its own only while the wheel slips
  bool left_slips_ = false;
  bool right_slips_ = false;
};

}  // namespace fulbito
