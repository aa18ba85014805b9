#include "engine/sim/surface.hpp"

#include <algorithm>

namespace fulbito {

Surface surfaceOf(const RobotModel& robot) {
  return {Surface::Kind::kRobot, robot.friction, robot.restitution, robot.restitution};
}

Surface surfaceOf(const BallModel& ball) {
  return {Surface::Kind::kBall, ball.friction, ball.robot_restitution, ball.wall_restitution};
}

PairSurface pairOf(const Surface& a, const Surface& b) {
  if (a.kind == b.kind) {
    return {std::max(a.friction, b.friction), std::max(a.hard_restitution, b.hard_restitution)};
  }
  const Surface& first = a.kind > b.kind ? a : b;
  const Surface& second = a.kind > b.kind ? b : a;
  return {first.friction, second.kind == Surface::Kind::kWall ? first.hard_restitution : first.restitution};
}

}  // namespace fulbito
