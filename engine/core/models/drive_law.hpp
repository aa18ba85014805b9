#pragma once

#include <algorithm>
#include <cmath>

#include "engine/core/models/wheel_pair.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// A speed of the two wheels' rims [m/s], or a change of it.
struct RimSpeeds {
  double left = 0.0;
  double right = 0.0;
};

/// How two motors of limited force and the drag change a robot's motion during a time step. The world and all
/// predictions use this law. Both forces act on one body: a force at one wheel moves and turns the body,
/// which also moves the other wheel. Each motor pulls until its rim reaches the target, up to its limit.
///
/// A wheel of some width stands on its two edges, which move over the ground at different speeds in a turn.
/// Both grip by Coulomb friction, so only one of them rolls: the faster one if the wheel pushes and the
/// slower one if it brakes. In between the edges scrub against each other and the wheel gives no pull. So a
/// robot that has to push in a curve loses half of the width times the yaw rate. The grip that the motors
/// leave unused brakes the turn.
class DriveLaw {
 public:
  /// @param dt  [s] length of the time step
  DriveLaw(const RobotModel& robot, double dt);

  /// Pulls of the two motors, each over half the mass, times `dt` [m/s].
  /// @param ground  the rims' speed over the ground [m/s]
  /// @param target  their wanted speed [m/s]
  /// @param limits  largest pull of each motor [m/s]
  RimSpeeds pulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const;
  /// Change of the rims' speed over the ground [m/s] that the pulls, the drag and the scrubbing edges make.
  RimSpeeds change(RimSpeeds ground, RimSpeeds pulls) const;
  /// The rims' speed over the ground [m/s] that a commanded one leads to. In a curve of radius R at speed v
  /// the wheels slip, and the body drives a curve of radius R + widening v + rise v^2 at the same speed (Choi
  /// & Lee 2005, Tables 5 and 6). Between a wheel that stands and a spin in place the effect fades to none.
  RimSpeeds reached(RimSpeeds commanded) const {
    return widening_ == 0.0 && rise_ == 0.0 ? commanded : reachedInCurve(commanded);
  }
  /// The command for which `reached` gives `wanted` [m/s].
  RimSpeeds commandFor(RimSpeeds wanted) const;
  double limit() const { return limit_; }  ///< [m/s] largest pull of one motor

 private:
  WheelPair resistedPulls(WheelPair ground, WheelPair target, WheelPair limits) const;
  WheelPair scrub(WheelPair turn, WheelPair pulls) const;
  double widening(double forward) const;
  RimSpeeds reachedInCurve(RimSpeeds commanded) const;

  double limit_;     // [m/s] largest pull of a motor
  double drag_;      // [m/s]
  double most_[2];   // [m/s] largest forward change: speeding up, slowing down
  double turn_;      // change of the rims' speed in a turn per pull
  double own_;       // pull per change of the wheel's own rim, if neither motor is at its limit
  double other_;     // pull per change of the other rim, under the same condition
  double felt_;      // change of a rim per pull at the other wheel
  double per_pull_;  // pull per change of its own rim, for a given pull at the other wheel
  double edges_;     // difference of a wheel's edges' speeds per difference of the rims' speeds
  double scrub_;     // change of the rims by scrubbing edges per grip that the motors leave
  double grip_;      // [m/s] grip of both wheels
  bool resisted_;    // whether drag or scrubbing edges resist the motion
  double widening_;  // [s/m] per half the difference of the rims' speeds, which stands for the yaw rate
  double rise_;      // [s^2/m^2]
};

// These functions run once per robot and physics step: a call would cost as much as the work.

inline RimSpeeds DriveLaw::pulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const {
  if (resisted_) {
    const WheelPair pull =
        resistedPulls({ground.left, ground.right}, {target.left, target.right}, {limits.left, limits.right});
    return {pull.left(), pull.right()};
  }
  const RimSpeeds lack{target.left - ground.left, target.right - ground.right};
  RimSpeeds pull{own_ * lack.left + other_ * lack.right, own_ * lack.right + other_ * lack.left};
  if (std::abs(pull.left) <= limits.left && std::abs(pull.right) <= limits.right) return pull;
  // If one motor is at its limit, the other one only controls its own rim.
  const auto limited = [&](double rim_lack, double other_pull, double limit) {
    return std::clamp((rim_lack - felt_ * other_pull) * per_pull_, -limit, limit);
  };
  if (std::abs(pull.left) * limits.right >= std::abs(pull.right) * limits.left) {
    pull.right = limited(lack.right, std::clamp(pull.left, -limits.left, limits.left), limits.right);
    pull.left = limited(lack.left, pull.right, limits.left);
  } else {
    pull.left = limited(lack.left, std::clamp(pull.right, -limits.right, limits.right), limits.left);
    pull.right = limited(lack.right, pull.left, limits.right);
  }
  return pull;
}

// Coulomb friction: it stops the turn at most. `turn` is half the difference of the rims' speeds.
inline WheelPair DriveLaw::scrub(WheelPair turn, WheelPair pulls) const {
  const WheelPair left_over = WheelPair(grip_) - pulls.abs().sum();
  const WheelPair most = WheelPair(scrub_) * left_over.atLeast(WheelPair(0.0));
  return -turn.clamped(-most, most);
}

inline RimSpeeds DriveLaw::change(RimSpeeds ground, RimSpeeds pulls) const {
  const double forward = (ground.left + ground.right) / 2, pull = (pulls.left + pulls.right) / 2;
  const double raw = pull - std::clamp(forward + pull, -drag_, drag_);  // drag: until the robot rests
  const double most = most_[raw * forward < 0.0 ? 1 : 0];
  const double common = std::clamp(raw, -most, most);
  const WheelPair turning((ground.right - ground.left) / 2);
  const double turn =
      turn_ * (pulls.right - pulls.left) / 2 + scrub(turning, {pulls.left, pulls.right}).left();
  return {common - turn, common + turn};
}

}  // namespace fulbito
