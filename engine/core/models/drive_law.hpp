#pragma once

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
class DriveLaw {
 public:
  /// @param dt  [s] length of the time step
  DriveLaw(const RobotModel& robot, double dt);

  /// Pulls of the two motors, each over half the mass, times `dt` [m/s].
  /// @param ground  the rims' speed over the ground [m/s]
  /// @param target  their wanted speed [m/s]
  /// @param limits  largest pull of each motor [m/s]
  RimSpeeds pulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const;
  /// Change of the rims' speed over the ground [m/s] that the pulls and the drag make.
  RimSpeeds change(RimSpeeds ground, RimSpeeds target, RimSpeeds pulls) const;
  /// The rims' speed over the ground [m/s] that a commanded one leads to. In a curve of radius R at speed v
  /// the wheels slip, and the body drives a curve of radius R + widening v + rise v^2 at the same speed (Choi
  /// & Lee 2005, Tables 5 and 6). Between a wheel that stands and a spin in place the effect fades to none.
  RimSpeeds reached(RimSpeeds commanded) const;
  /// The command for which `reached` gives `wanted` [m/s].
  RimSpeeds commandFor(RimSpeeds wanted) const;
  double limit() const { return limit_; }  ///< [m/s] of one motor

 private:
  double drag(double forward, double forward_target) const;
  double widening(double forward) const;

  double limit_;     // [m/s]
  double drag_;      // [m/s]
  double gain_;      // [m/s] largest forward change when speeding up
  double loss_;      // [m/s] the same when slowing down
  double turn_;      // rims' change in place over the pull that makes it
  double own_;       // pull for a change of the wheel's own rim, if neither motor is at its limit
  double other_;     // the same for the other rim's change
  double felt_;      // change of a rim by a pull at the other wheel
  double per_pull_;  // pull for a change of its own rim
  double widening_;  // [s/m] of the rims' difference: yaw rates count as rim speeds here
  double rise_;      // [s^2/m^2]
};

}  // namespace fulbito
