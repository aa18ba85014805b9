#include "strategies/teams/libero/attack/caught.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito::libero {

bool isCaught(const Picture& picture, const RobotState& self, StrikerMemory& memory) {
  constexpr double kTouch = 0.075;                     // [m]
  constexpr double kPatience = 0.3, kDriveOff = 0.15;  // [s]
  const bool still = squaredNorm(self.velocity) < 0.04 * 0.04 && std::abs(self.angular_velocity) < 0.6;
  const bool held = still && squaredNorm(picture.ball.now().position - self.pose.position) > kTouch * kTouch;
  memory.freeing -= picture.seen.dt;
  memory.caught = held && memory.freeing <= 0.0 ? memory.caught + picture.seen.dt : 0.0;
  if (memory.caught > kPatience) memory.freeing = kDriveOff;
  return memory.freeing > 0.0;
}

Twist driveOff(const Pitch& pitch, const RobotState& self) {
  constexpr double kSpeed = 0.5, kTurn = 4.0;  // [m/s], [rad/s]
  const Vec2 place = self.pose.position;
  const bool in_mouth =
      std::abs(place.x) > pitch.half_length - pitch.robot_corner && std::abs(place.y) < pitch.goal_half;
  const Vec2 off = in_mouth ? Vec2{-0.3 * place.x, -place.y} : -place;
  const Vec2 out = in_mouth ? Vec2{-place.x, 0.0} : off;
  const Vec2 face = math::unit(self.pose.heading);
  const double end = std::copysign(1.0, dot(face, off));
  return {end * kSpeed, std::copysign(kTurn, cross(face * end, out))};
}

}  // namespace fulbito::libero
