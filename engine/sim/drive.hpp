#pragma once

#include <algorithm>
#include <cmath>

#include "engine/core/models/drive_law.hpp"
#include "engine/core/models/spin_ratio.hpp"
#include "engine/sim/tilt.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Motion of a robot's body in its own frame.
struct BodyMotion {
  double forward = 0.0;   ///< [m/s]
  double sideways = 0.0;  ///< [m/s] toward the left
  double yaw = 0.0;       ///< [rad/s] counter-clockwise
};

/// Motors, wheels and tyres of one robot. The motors drive the rims toward the command by the `DriveLaw`. The
/// floor transmits at most the tyre's grip; beyond it the wheel slips. Across the wheels, the tyres resist up
/// to a limit of their own (Coulomb).
class Drive {
 public:
  /// @param step_period   [s] one physics step
  /// @param command_step  [rad/s] commands are rounded to multiples of it; <= 0: not rounded
  Drive(const RobotModel& robot, double step_period, double command_step);

  /// Sets the commanded wheel speeds: NaN becomes 0, then they are clamped and rounded.
  void setCommand(WheelSpeeds command);

  /// The change of the body's motion by motors and floor in one physics step.
  /// @param robot  its present motion
  /// @param push  the change that contacts are about to make in the step; motors and tyres hold against it
  BodyMotion step(const BodyMotion& robot, const BodyMotion& push = {});

  /// Encoder readings [rad/s] of a body that moves at `forward` [m/s] and `yaw` [rad/s]: the ground speed, or
  /// the wheel's own speed while it slips.
  WheelSpeeds encoders(double forward, double yaw) const;

 private:
  double rimTarget(double wheel_speed) const;
  double scrubbedTurn(double common, double half_difference) const;
  double slippingLimit(double pull, double target, double ground, double& rim, bool& slips) const;
  RimSpeeds slippingPulls(RimSpeeds ground, RimSpeeds pulls);
  RimSpeeds limits(const BodyMotion& motion) const;
  bool rests(const BodyMotion& motion) const;
  BodyMotion tiltedStep(const BodyMotion& motion, RimSpeeds ground);
  BodyMotion pushed(const BodyMotion& motion, const BodyMotion& push) const;

  DriveLaw law_;
  Tilt tilt_;
  SpinRatio spin_ratio_;
  double max_wheel_speed_;
  double command_step_;      // [rad/s], 0: not rounded
  double per_command_step_;  // [s/rad]
  double radius_;            // [m]
  double half_track_;        // [m]
  double per_radius_;        // [1/m]
  double max_grip_;          // [m/s] grip along the wheels in one step
  double max_lateral_;       // [m/s] grip across the wheels in one step
  double load_shift_;        // [s^2/m] change of a wheel's share of the grip per acceleration across
  double outer_edge_;        // distance between the wheels' outer edges over the axle track
  double per_play_;  // half the rims' difference over the driving speed up to which the robot turns in place
  WheelSpeeds command_;  // [rad/s] as given to `setCommand`
  RimSpeeds target_;     // target speeds of the rims, after limits and scrubbing
  RimSpeeds rim_;        // speeds of the rims; valid only while the wheel slips
  bool left_slips_ = false;
  bool right_slips_ = false;
};

inline WheelSpeeds Drive::encoders(double forward, double yaw) const {
  const double turn = yaw * half_track_;
  if (tilt_.isTilted()) return {tilt_.rims().left * per_radius_, tilt_.rims().right * per_radius_};
  const double left = left_slips_ ? rim_.left : forward - turn;
  const double right = right_slips_ ? rim_.right : forward + turn;
  return {left * per_radius_, right * per_radius_};
}

// In a curve the inner wheel bears less, and so pulls less.
inline RimSpeeds Drive::limits(const BodyMotion& motion) const {
  if (load_shift_ == 0.0) return {law_.limit(), law_.limit()};
  const double shift = load_shift_ * motion.forward * motion.yaw;
  return {std::clamp((1.0 - shift) * max_grip_, 0.0, law_.limit()),
          std::clamp((1.0 + shift) * max_grip_, 0.0, law_.limit())};
}

// Whether the robot rests and has no command to move: then the step changes nothing.
inline bool Drive::rests(const BodyMotion& motion) const {
  return motion.forward == 0.0 && motion.yaw == 0.0 && target_.left == 0.0 && target_.right == 0.0 &&
         !tilt_.isTilted();
}

// The motion that motors and tyres answer. A robot that drives at something gives all the force that its
// motors have, so there the push is left out: it would pass for a motion backwards, which motors brake with
// more force.
inline BodyMotion Drive::pushed(const BodyMotion& motion, const BodyMotion& push) const {
  const bool against = (target_.left + target_.right) * push.forward < 0.0;
  return {against ? motion.forward : motion.forward + push.forward, motion.sideways + push.sideways,
          motion.yaw + push.yaw};
}

inline BodyMotion Drive::step(const BodyMotion& robot, const BodyMotion& push) {
  const BodyMotion motion = pushed(robot, push);
  if (rests(motion)) {
    left_slips_ = right_slips_ = false;
    return {0.0, -std::clamp(motion.sideways, -max_lateral_, max_lateral_), 0.0};
  }
  const double turn = motion.yaw * half_track_;
  const RimSpeeds ground{motion.forward - turn, motion.forward + turn};
  RimSpeeds pulls = law_.pulls(ground, target_, limits(motion));
  if (tilt_.isOff(motion.forward, pulls)) return tiltedStep(motion, ground);
  if (std::abs(pulls.left) <= max_grip_ && std::abs(pulls.right) <= max_grip_) {
    left_slips_ = right_slips_ = false;
  } else {
    pulls = slippingPulls(ground, pulls);
  }
  const RimSpeeds change = law_.change(ground, pulls);
  return {(change.left + change.right) / 2, -std::clamp(motion.sideways, -max_lateral_, max_lateral_),
          (change.right - change.left) / (2 * half_track_)};
}

}  // namespace fulbito
