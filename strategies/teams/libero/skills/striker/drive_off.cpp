#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether a wall or a post holds a robot that wants to turn, for instance in a goal mouth.
bool isCaught(const Picture& picture, int robot, Memory::DriveOff& memory) {
  constexpr double kPatience = 0.3, kDriveOff = 0.15;  // [s]
  const RobotState& self = picture.own(robot);
  const bool still = squaredNorm(self.velocity) < 0.04 * 0.04 && std::abs(self.angular_velocity) < 0.6;
  const bool held = still && squaredNorm(picture.ballFrom(robot)) > kTouch * kTouch;
  memory.left -= picture.seen.dt;
  memory.caught = held && memory.left <= 0.0 ? memory.caught + picture.seen.dt : 0.0;
  if (memory.caught > kPatience) memory.left = kDriveOff;
  return memory.left > 0.0;
}

/// Drives toward the field's middle. In a goal mouth the robot moves away from the post and turns out of the
/// mouth; otherwise it would come back to the same place.
Twist off(const Pitch& pitch, const RobotState& self) {
  constexpr double kSpeed = 0.5, kTurn = 4.0;  // [m/s], [rad/s]
  const Vec2 place = self.pose.position;
  const bool in_mouth =
      std::abs(place.x) > pitch.half_length - pitch.robot_corner && std::abs(place.y) < pitch.goal_half;
  const Vec2 away = in_mouth ? Vec2{-0.3 * place.x, -place.y} : -place;
  const Vec2 out = in_mouth ? Vec2{-place.x, 0.0} : away;
  const Vec2 face = math::unit(self.pose.heading);
  const double end = std::copysign(1.0, dot(face, away));
  return {end * kSpeed, std::copysign(kTurn, cross(face * end, out))};
}

}  // namespace

std::optional<Move> driveOff(const Picture& picture, int robot, Memory& memory) {
  if (!isCaught(picture, robot, memory.drive_off)) return std::nullopt;
  return Move{.twist = off(picture.pitch, picture.own(robot)), .reason = "a wall or a post holds it"};
}

}  // namespace fulbito::libero::striker
