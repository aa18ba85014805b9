#include "navigation/methods/hybrid/body_room.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// Lengths at a body of 7.5 cm.
constexpr double kReach = 0.12;  // [m] of what is looked at
constexpr double kQuick = 0.06;  // [m] nearer echoes count at once: their arcs are points
constexpr double kMost = 0.05;   // [m] farther things do not matter
constexpr double kTime = 0.1;    // [s] for which a turn is foreseen

}  // namespace

double bodySize(const RobotModel& robot) { return robot.width / 0.075; }

void BodyRoom::look(const NavigationScene& scene, const ProvenMap& map,
                    std::span<const RangeSmoother> smoothers) {
  half_length_ = scene.robot->length / 2, half_width_ = scene.robot->width / 2;
  size_ = bodySize(*scene.robot);
  points_.clear();
  const Vec2 place = scene.self.pose.position, ahead = math::unit(scene.self.pose.heading);
  map.forOccupied(place, kReach * size_, [&](int x, int y, const ProvenMap::Cell&) {
    points_.push_back(intoFrame(ahead, map.middle(x, y) - place));
  });
  for (std::size_t i = 0; i < std::min(smoothers.size(), scene.ranges.size()); ++i) {
    const Pose2& mount = scene.ranges[i].mount;
    const auto range = smoothers[i].recent();
    if (range && *range < kQuick * size_)
      points_.push_back(mount.position + math::unit(mount.heading) * *range);
  }
  here_ = at({}, 0.0);
  radius_ = scene.robot->circumradius(), nearest_ = kReach * size_;
  for (const Vec2 point : points_) nearest_ = std::min(nearest_, norm(point));
}

double BodyRoom::at(Vec2 place, double turn) const {
  double least = kMost * size_;
  const Vec2 ahead = math::unit(turn);
  for (const Vec2 point : points_) {
    const Vec2 p = intoFrame(ahead, point - place);
    const double x = std::abs(p.x) - half_length_, y = std::abs(p.y) - half_width_;
    least = std::min(least, x > 0.0 && y > 0.0 ? norm({x, y}) : std::max(x, y));
  }
  return least;
}

bool BodyRoom::turns(double rate, double most, double margin) const {
  return at({}, std::clamp(rate * kTime, -std::abs(most), std::abs(most))) >= floor(margin);
}

}  // namespace fulbito
