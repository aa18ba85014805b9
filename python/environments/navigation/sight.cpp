#include "python/environments/navigation/sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

using namespace navigation_sight;

/// Distance along a ray from the origin to a disc.
double toDisc(Vec2 direction, Vec2 centre, double radius) {
  const double along = dot(direction, centre);
  const double inside = radius * radius - (squaredNorm(centre) - along * along);
  if (squaredNorm(centre) < radius * radius) return 0.0;
  if (inside < 0.0 || along < 0.0) return kFarthest;
  return along - std::sqrt(inside);
}

/// Distance along a ray from the origin to the segment from `a` to `b`.
double toSegment(Vec2 direction, Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  const double across = cross(direction, edge);
  if (across == 0.0) return kFarthest;
  const double along = cross(a, edge) / across;
  const double share = cross(a, direction) / across;
  return along >= 0.0 && share >= 0.0 && share <= 1.0 ? along : kFarthest;
}

class Numbers {
 public:
  explicit Numbers(std::span<float> out) : out_(out) {}
  void add(double value) {
    const auto bound = static_cast<double>(kSightBound);
    out_[at_++] = static_cast<float>(std::clamp(value, -bound, bound));
  }
  void add(Vec2 v) {
    add(v.x);
    add(v.y);
  }

 private:
  std::span<float> out_;
  std::size_t at_ = 0;
};

void addRays(Numbers& numbers, const NavigationScene& scene, const std::vector<Vec2>& contour) {
  const Vec2 at = scene.self.pose.position;
  for (std::size_t i = 0; i < kRays; ++i) {
    const double turn = 2.0 * math::kPi * static_cast<double>(i) / kRays;
    const Vec2 direction = math::unit(scene.self.pose.heading + turn);
    double free = kFarthest;
    for (const DiscObstacle& disc : scene.obstacles) {
      free = std::min(free, toDisc(direction, disc.position - at, disc.radius));
    }
    for (std::size_t k = 0; k < contour.size(); ++k) {
      free = std::min(free, toSegment(direction, contour[k] - at, contour[(k + 1) % contour.size()] - at));
    }
    numbers.add(free);
  }
}

/// The nearest obstacles, by the gap to their edge.
void addDiscs(Numbers& numbers, const NavigationScene& scene, Vec2 ahead, double top_speed) {
  std::array<const DiscObstacle*, kDiscs> nearest{};
  const auto gap = [&](const DiscObstacle& disc) {
    return distance(disc.position, scene.self.pose.position) - disc.radius;
  };
  for (const DiscObstacle& disc : scene.obstacles) {
    const DiscObstacle* candidate = &disc;
    for (const DiscObstacle*& place : nearest) {
      if (place == nullptr || gap(*candidate) < gap(*place)) std::swap(place, candidate);
      if (candidate == nullptr) break;
    }
  }
  for (const DiscObstacle* disc : nearest) {
    if (disc == nullptr) {
      for (std::size_t i = 0; i < kDiscNumbers; ++i) numbers.add(0.0);
      continue;
    }
    numbers.add(1.0);
    numbers.add(intoFrame(ahead, disc->position - scene.self.pose.position));
    numbers.add(disc->radius);
    numbers.add(intoFrame(ahead, disc->velocity) / top_speed);
  }
}

}  // namespace

void NavigationSight::write(const NavigationScene& scene, std::span<float> out) {
  if (scene.field != field_) {
    field_ = scene.field;
    contour_ = innerContour(*field_);
  }
  const RobotState& self = scene.self;
  const RobotModel& robot = *scene.robot;
  const double top_speed = robot.maxSpeed();
  const Vec2 ahead = math::unit(self.pose.heading);
  const Vec2 to_goal = scene.goal.position - self.pose.position;
  Numbers numbers(out);
  numbers.add(intoFrame(ahead, to_goal));
  numbers.add(norm(to_goal));
  numbers.add(math::unit(math::angleOf(to_goal) - self.pose.heading));
  numbers.add(scene.goal.heading ? math::unit(*scene.goal.heading - self.pose.heading) : Vec2{});
  numbers.add(intoFrame(ahead, self.velocity) / top_speed);
  numbers.add(self.angular_velocity * robot.axle_track / (2.0 * top_speed));
  numbers.add(Vec2{self.wheels.left, self.wheels.right} / robot.max_wheel_speed);
  numbers.add(top_speed);
  addRays(numbers, scene, contour_);
  addDiscs(numbers, scene, ahead, top_speed);
  for (std::size_t i = 0; i < kSonars; ++i) {
    numbers.add(i < scene.ranges.size() ? scene.ranges[i].range : 0.0);
  }
}

}  // namespace fulbito
