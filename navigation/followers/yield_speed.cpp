#include "navigation/followers/yield_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "navigation/followers/path_tracker.hpp"
#include "navigation/obstacles/path_problem.hpp"

namespace fulbito {
namespace {

constexpr std::array<double, 5> kShares = {1.0, 0.7, 0.45, 0.2, 0.0};
constexpr double kStep = 0.025;             // [s]
constexpr double kApart = 0.01;             // [m] gap beside the circumscribed circle
constexpr double kAccelerationShare = 0.6;  // share of the wheel acceleration, as in the follower
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Whether the robot at `p` at time `t` [s] is too near to a moving obstacle, and nearer than now.
bool meets(const NavigationScene& scene, Vec2 p, double t) {
  const double radius = scene.robot->circumradius() + kApart;
  return std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const DiscObstacle& o) {
    if (!isMoving(o)) return false;
    const double apart = std::min(radius + o.radius, distance(scene.self.pose.position, o.position));
    return squaredNorm(o.position + o.velocity * t - p) < apart * apart;
  });
}

/// Time [s] of the first meeting if the robot changes its speed to `target` [m/s]; infinite if there is none.
double meetingAt(const NavigationScene& scene, std::span<const Vec2> path, PathPlace place, double target,
                 double horizon) {
  const double change = kAccelerationShare * scene.robot->wheel_acceleration * kStep;
  double speed = norm(scene.self.velocity);
  double t = kStep;
  while (t <= horizon) {
    speed += std::clamp(target - speed, -change, change);
    place = advance(path, place, speed * kStep);
    if (meets(scene, pointAt(path, place), t)) return t;
    t += kStep;
  }
  return kInfinity;
}

}  // namespace

double yieldSpeed(const NavigationScene& scene, std::span<const Vec2> path, double horizon) {
  const bool moving = std::any_of(scene.obstacles.begin(), scene.obstacles.end(), isMoving);
  if (!moving || path.size() < 2) return kInfinity;
  PathTracker tracker;
  const PathPlace here = tracker.locate(path, 0, scene.self.pose.position);
  double best = kInfinity, latest = 0.0;
  for (double share : kShares) {
    const double target = share * scene.robot->maxSpeed();
    const double meeting = meetingAt(scene, path, here, target, horizon);
    if (meeting <= latest) continue;
    latest = meeting;
    best = share < 1.0 ? target : kInfinity;
    if (meeting == kInfinity) break;
  }
  return best;
}

}  // namespace fulbito
