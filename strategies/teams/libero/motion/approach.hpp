#pragma once

#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {

/// [m] circle on which a robot comes round the ball.
inline constexpr double kRound = 0.09;

/// Heading [rad] of the field that leads behind the ball and through it: tangents to a circle about the
/// contact, then the N-posture field (Univector, 3.1). `side` breaks the tie where the robot is right in
/// front: it is kept.
double approachHeading(Vec2 robot, Vec2 contact, double direction, double radius, double sharpness,
                       int& side);

/// Drives so as to hit `contact` along the unit vector `direction`: round it on a circle of `round` [m] while
/// it is in front of it, slow enough for that circle, then onto the line behind it, slow enough to be aligned
/// before the touch. `rolling` is the ball's velocity [m/s].
Twist driveThrough(const Pitch& pitch, const RobotState& self, Vec2 contact, Vec2 direction, double round,
                   Vec2 rolling, int& side);

}  // namespace fulbito::libero
