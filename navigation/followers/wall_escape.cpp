#include "navigation/followers/wall_escape.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "navigation/followers/limiter.hpp"
#include "navigation/geometry/near_walls.hpp"

namespace fulbito {
namespace {

constexpr double kReach = 0.02;  // [m] beyond the circumradius
constexpr double kFree = 0.005;  // [m] beyond the circumradius, where the escape ends
constexpr double kWallCone = 50.0 * math::kPi / 180.0;
constexpr double kCornerCone = 75.0 * math::kPi / 180.0;
constexpr double kConeHysteresis = 10.0 * math::kPi / 180.0;
constexpr double kSpeedShare = 0.2;   // share of the top speed
constexpr double kMostSpeed = 0.3;    // [m/s] a faster robot would still roll into the wall after the turn
constexpr double kYawGain = 4.0;      // [1/s]
constexpr double kSlow = 0.15;        // [m/s]
constexpr double kLeastTurn = 1.0;    // [rad/s] a smaller wanted yaw rate needs no escape
constexpr double kTouch = 0.001;      // [m]
constexpr double kLongest = 1.0;      // [s] longest escape
constexpr double kRest = 0.5;         // [s] time before the next escape
constexpr double kWayOut = 0.02;      // [m] length of the way out that must be free of obstacles
constexpr int kSamples = 6;           // samples of the motion under the wanted twist
constexpr double kSampleTime = 0.02;  // [s] between samples

/// The walls within reach of the robot, treated as one.
struct Barrier {
  int walls = 0;
  double gap = 1e9;  ///< [m] from the robot's centre to the nearest wall
  Vec2 inward;
};

Barrier barrierAt(const FieldGeometry& field, Vec2 p, double reach, double post) {
  Barrier barrier;
  for (const NearWall& wall : nearWalls(field, p, post)) {
    barrier.gap = std::min(barrier.gap, wall.gap);
    if (wall.gap >= reach) continue;
    ++barrier.walls;
    barrier.inward += wall.inward;
  }
  return barrier;
}

/// Distance [m] from the body's nearest corner to the walls; negative beyond them.
double bodyGap(const NavigationScene& scene, const Pose2& pose) {
  const Vec2 ux = math::unit(pose.heading);
  const Vec2 ahead = ux * (scene.robot->length / 2), left = perp(ux) * (scene.robot->width / 2);
  double least = 1e9;
  for (Vec2 corner : {ahead + left, ahead - left, -ahead + left, -ahead - left}) {
    for (const NearWall& wall : nearWalls(*scene.field, pose.position + corner, 0.0)) {
      least = std::min(least, wall.gap);
    }
  }
  return least;
}

/// Whether the wanted twist would soon press the body into a wall, or deeper into one.
bool pressesIntoWall(const NavigationScene& scene, Twist wanted) {
  Pose2 pose = scene.self.pose;
  double speed = bodyTwist(scene.self).linear;
  const double limit = std::min(kTouch, bodyGap(scene, pose) - kTouch);
  const double change = scene.robot->wheel_acceleration * kSampleTime;
  for (int i = 0; i < kSamples; ++i) {
    speed += std::clamp(wanted.linear - speed, -change, change);
    pose.position += math::unit(pose.heading) * (speed * kSampleTime);
    pose.heading = math::wrapAngle(pose.heading + wanted.angular * kSampleTime);
    if (bodyGap(scene, pose) < limit) return true;
  }
  return false;
}

bool wayOutFree(const NavigationScene& scene, double direction) {
  const Vec2 way = math::unit(scene.self.pose.heading) * direction;
  const Vec2 there = scene.self.pose.position + way * kWayOut;
  for (const DiscObstacle& o : scene.obstacles) {
    const bool near = distance(there, o.position) < o.radius + scene.robot->circumradius();
    if (near && dot(o.position - scene.self.pose.position, way) > 0.0) return false;
  }
  return true;
}

/// -1 if the heading points at the barrier, +1 if it points away from it, both within the cone; otherwise 0.
double wayOut(const Barrier& barrier, double heading, double widening) {
  if (barrier.walls == 0) return 0.0;
  const double cone = (barrier.walls > 1 ? kCornerCone : kWallCone) + widening;
  const double off = std::abs(math::wrapAngle(heading - math::angleOf(barrier.inward)));
  if (off <= cone) return 1.0;
  return math::kPi - off <= cone ? -1.0 : 0.0;
}

Twist escapeTwist(const NavigationScene& scene, double direction) {
  const Pose2& pose = scene.self.pose;
  const double turn = math::wrapAngle(math::angleOf(scene.goal.position - pose.position) - pose.heading);
  // A corner of the body may swing toward the wall no faster than the body moves away.
  const double leaving = std::max(0.0, direction * bodyTwist(scene.self).linear);
  const double most = leaving / scene.robot->circumradius();
  const double speed = std::min(kSpeedShare * scene.robot->maxSpeed(), kMostSpeed);
  return {direction * speed, std::clamp(kYawGain * turn, -most, most)};
}

}  // namespace

void WallEscape::reset() { *this = {}; }

Twist WallEscape::apply(const NavigationScene& scene, Twist wanted) {
  const double radius = scene.robot->circumradius();
  const Pose2& pose = scene.self.pose;
  const Barrier barrier = barrierAt(*scene.field, pose.position, radius + kReach, radius);
  if (active()) {
    const bool late = static_cast<double>(scene.tick - since_) * scene.dt > kLongest;
    if (late) rest_until_ = scene.tick + static_cast<Tick>(kRest / scene.dt);
    if (late || barrier.gap > radius + kFree ||
        wayOut(barrier, pose.heading, kConeHysteresis) != direction_ || !wayOutFree(scene, direction_)) {
      direction_ = 0.0;
    }
  } else if (scene.tick >= rest_until_ && std::abs(bodyTwist(scene.self).linear) < kSlow &&
             std::abs(wanted.angular) > kLeastTurn) {
    const double out = wayOut(barrier, pose.heading, 0.0);
    if (out != 0.0 && wayOutFree(scene, out) && pressesIntoWall(scene, wanted)) {
      direction_ = out;
      since_ = scene.tick;
    }
  }
  return active() ? escapeTwist(scene, direction_) : wanted;
}

}  // namespace fulbito
