#pragma once

#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// Drives along `heading` [rad] at `speed` [m/s] with the end that needs the smaller turn; a moving robot
/// keeps its leading end unless the other is clearly nearer. While it turns, the speed falls by the squared
/// cosine of the error. `gain` [1/s] is the yaw rate per error, by default `Tuning::turn_gain`.
Twist alongHeading(const Pitch& pitch, const RobotState& robot, double heading, double speed);
Twist alongHeading(const Pitch& pitch, const RobotState& robot, double heading, double speed, double gain);

/// The gain [1/s] of a turn toward a place that is `way` [m] away. Motors that turn a robot are missing for
/// its speed. So a robot that speeds up slowly turns over the time that the way takes.
double turnGain(const Pitch& pitch, const RobotState& robot, double way);

/// The greatest yaw rate [rad/s] from which the robot can stop after a turn by `angle` [rad] >= 0.
double fastestTurn(const Pitch& pitch, double angle);

/// Turns in place until one end points along `heading`.
Twist turnTo(const Pitch& pitch, const RobotState& robot, double heading);

/// The slow speed [m/s] along its heading at which a robot that turns in place mends the rest of its way
/// [m].
double creeping(const Pitch& pitch, double way);

/// Drives to `place`, stops there and turns an end to `heading`. The turn begins `heading_from` [m] before
/// the place.
Twist restAt(const Pitch& pitch, const RobotState& robot, Vec2 place, double heading, double heading_from);

/// Drives through `place` at full speed.
Twist passThrough(const Pitch& pitch, const RobotState& robot, Vec2 place);

/// Difference of two headings when either end may lead, in [-pi/2, pi/2].
double foldedError(double wanted, double heading);

}  // namespace fulbito::libero
