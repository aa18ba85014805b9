#include "experiments/capture/tracker.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito::capture {
namespace {

// Gains of the errors along the way, across it and in heading. At speed v the error across the way falls as
// that of a system of frequency sqrt(kAcross) v with damping kTurn / (2 sqrt(kAcross)): 1.5 per metre, 0.83.
constexpr double kAlong = 0.8;    // [1/s]
constexpr double kAcross = 2.25;  // [1/m^2]
constexpr double kTurn = 2.5;     // [1/m]

}  // namespace

WheelSpeeds wheelsOverGround(const RobotModel& robot, const DriveLaw& law, Twist twist) {
  const double turn = twist.angular * robot.axle_track / 2;
  const RimSpeeds rims = law.commandFor({twist.linear - turn, twist.linear + turn});
  return saturate(robot, {rims.left / robot.wheel_radius, rims.right / robot.wheel_radius});
}

Twist trackingTwist(const MotionState& reference, const Pose2& robot) {
  const Vec2 off = reference.pose.position - robot.position, ahead = math::unit(robot.heading);
  const math::SinCos turned = math::sinCos(math::wrapAngle(reference.pose.heading - robot.heading));
  const double speed = reference.twist.linear;
  return {speed * turned.cos + kAlong * dot(off, ahead),
          reference.twist.angular + speed * (kAcross * cross(ahead, off) + kTurn * turned.sin)};
}

}  // namespace fulbito::capture
