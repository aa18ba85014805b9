#pragma once

#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {

/// Gap [m] between robot and ball on the way round a ball at `x` [m]. At their goal it is the braking way, in
/// which a robot that turns toward the ball still slides at it, but at most half of its body: a wider circle
/// leaves the ball to opponents. Toward our goal it falls to the clearance: there the first touch is worth
/// more than a clean one.
double roundGap(const Pitch& pitch, double x);

/// Radius [m] of the circle on which a robot drives round a ball at `x` [m].
double roundRadius(const Pitch& pitch, double x);

/// Angle [rad] between the direction to a ball `away` [m] and the way past it on a circle of `radius` [m]:
/// the tangent, or farther off the ball where the robot is within the circle.
double tangentAngle(double radius, double away);

/// Heading [rad] of the field that leads behind `contact` and through it along `direction` [rad]: tangents to
/// a circle of `radius` [m] about the contact, then the N-posture field (Univector, 3.1).
/// `side` is the direction round the ball, kept while the robot is right in front of it.
double approachHeading(const Pitch& pitch, Vec2 robot, Vec2 contact, double direction, double radius,
                       int& side);

/// Drives so as to hit `contact` along the unit vector `direction`. While the robot is in front of the ball,
/// it drives round it on a circle of radius `round` [m], slowly enough for that circle. The circle is as wide
/// as at their goal where straight on would send the ball into the own goal. Within `cone`, lateral per
/// forward distance, it follows the line behind the ball, slowly enough to be aligned before the touch.
/// `rolling` is the ball's velocity [m/s].
Twist driveThrough(const Pitch& pitch, const RobotState& self, Vec2 contact, Vec2 direction, double round,
                   double cone, Vec2 rolling, int& side);

}  // namespace fulbito::libero
