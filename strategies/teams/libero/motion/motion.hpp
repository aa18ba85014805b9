#pragma once

#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// [1/s] yaw rate per heading error, where a skill has no other.
inline constexpr double kTurnGain = 16.0;

/// Drives along `heading` [rad] at `speed` [m/s] with whichever end takes the smaller turn; a moving robot
/// keeps its end unless the other is clearly nearer. It slows down by the squared cosine of the error while
/// it turns; `gain` [1/s] is the yaw rate per error.
Twist alongHeading(const RobotState& robot, double heading, double speed, double gain = kTurnGain);

/// The yaw rate [rad/s] at which a turn by `angle` [rad] >= 0 can still be stopped in time.
double fastestTurn(const Pitch& pitch, double angle);

/// Turns on the spot until one end points along `heading`.
Twist turnTo(const Pitch& pitch, const RobotState& robot, double heading);

/// A place to be: comes to rest there, then turns an end to `heading`.
Twist restAt(const Pitch& pitch, const RobotState& robot, Vec2 place, double heading,
             double heading_from = 0.02);

/// Drives through `place` at speed.
Twist passThrough(const RobotState& robot, Vec2 place, double speed);

/// Difference of two headings when either end may lead, in [-pi/2, pi/2].
double foldedError(double wanted, double heading);

}  // namespace fulbito::libero
