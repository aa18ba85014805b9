#pragma once

#include "engine/core/models/robot_model.hpp"

namespace fulbito {

/// A speed of the two wheels' rims [m/s], or a change of it.
struct RimSpeeds {
  double left = 0.0;
  double right = 0.0;
};

/// What two limited motors and the drag do to a robot's motion in a time: the drive's law, one for the
/// world and for predictions. The motors' forces act on one body: a forward one at one wheel turns it and
/// moves it, which the other wheel feels. Each motor gives what its rim still lacks, up to its limit.
class DriveLaw {
 public:
  /// @param dt  [s] in which it acts
  DriveLaw(const RobotModel& robot, double dt);

  /// Pulls of the two motors, each over half the mass, times `dt` [m/s].
  /// @param ground  the rims' speed over the ground [m/s]
  /// @param target  what they are to reach [m/s]
  /// @param limits  the most that each may pull [m/s]
  RimSpeeds pulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const;
  /// Change of the rims' speed over the ground [m/s] that the pulls and the drag make.
  RimSpeeds change(RimSpeeds ground, RimSpeeds target, RimSpeeds pulls) const;
  double limit() const { return limit_; }  ///< [m/s] of one motor

 private:
  double drag(double forward, double forward_target) const;

  double limit_;     // [m/s]
  double drag_;      // [m/s]
  double gain_;      // [m/s] most change forward when speeding up
  double loss_;      // [m/s] the same when slowing down
  double turn_;      // rims' change in place over the pull that makes it
  double own_;       // pull that the wheel's own rim needs for a change, where both are free
  double other_;     // the same for the other rim's change
  double felt_;      // change of a rim by a pull at the other wheel ...
  double per_pull_;  // ... and pull for a change of its own
};

}  // namespace fulbito
