// Private header of strategies: not installed.
#pragma once

#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// How sharply a robot turns toward the wanted heading.
struct Steering {
  double gain = 16.0;      ///< [1/s] yaw rate for a heading error
  double slow_down = 2.0;  ///< power of the cosine of the error that slows the robot while it turns
};

/// Time [s] in which `robot` can be at `target`, turn and ramp included; either end may lead. The formula of
/// the reference page (2.1), with the speed that the robot already has.
double timeToReach(const Pitch& pitch, const RobotState& robot, Vec2 target);
/// The same where the unit vector `face` of its heading is known: for who asks of many targets.
double timeToReach(const Pitch& pitch, const RobotState& robot, Vec2 face, Vec2 target);

/// Drives along `heading` [rad] at `speed` [m/s] with whichever end takes the smaller turn; a moving robot
/// keeps its end unless the other is clearly nearer.
Twist alongHeading(const Pitch& pitch, const RobotState& robot, double heading, double speed,
                   const Steering& steering = {});

/// The yaw rate [rad/s] at which a turn by `angle` [rad] >= 0 can still be stopped in time.
double fastestTurn(const Pitch& pitch, double angle);

/// Turns on the spot until one end points along `heading`.
Twist turnTo(const Pitch& pitch, const RobotState& robot, double heading);

/// A place to be: comes to rest there, then turns an end to `heading`.
Twist restAt(const Pitch& pitch, const RobotState& robot, Vec2 place, double heading,
             double heading_from = 0.02);

/// Drives through `place` at speed.
Twist passThrough(const Pitch& pitch, const RobotState& robot, Vec2 place, double speed);

/// Difference of two headings when either end may lead, in [-pi/2, pi/2].
double foldedError(double wanted, double heading);

}  // namespace fulbito::libero
