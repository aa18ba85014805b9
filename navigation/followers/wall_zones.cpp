#include "navigation/followers/wall_zones.hpp"

#include "fulbito/detail/math.hpp"
#include "navigation/geometry/near_walls.hpp"

namespace fulbito {
namespace {

constexpr double kDepth = 0.095;  // [m] from the wall to the robot's centre
// Shares of the top speed: a fifth on average, on a circle of twice the axle track in diameter.
constexpr double kFasterWheel = 0.3, kSlowerWheel = 0.1;

}  // namespace

Twist WallZones::apply(const NavigationScene& scene, Twist wanted) {
  const Vec2 p = scene.self.pose.position;
  const auto walls = nearWalls(*scene.field, p, scene.robot->circumradius());
  if (wall_ && walls[*wall_].gap >= kDepth) wall_.reset();
  for (std::size_t i = 0; i < walls.size() && !active(); ++i) {
    const bool nearest = walls[i].gap <= walls[(i + 1) % 3].gap && walls[i].gap <= walls[(i + 2) % 3].gap;
    if (nearest && walls[i].gap < kDepth) wall_ = i;
  }
  if (!active()) return wanted;
  const Vec2 inward = walls[*wall_].inward;
  const bool left = cross(inward, scene.goal.position - p) >= 0.0;
  const bool forward = dot(math::unit(scene.self.pose.heading), inward) >= 0.0;
  const double top = scene.robot->maxSpeed(), faster = kFasterWheel * top, slower = kSlowerWheel * top;
  const double turn = (faster - slower) / scene.robot->axle_track;
  const double speed = (faster + slower) / 2;
  return {forward ? speed : -speed, left ? turn : -turn};
}

}  // namespace fulbito
