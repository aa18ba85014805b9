#include "navigation/methods/hybrid/passage.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/sonar_model.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// Lengths at the paper's robot.
constexpr double kReach = 0.25;     // [m] along the axis to the point that the robot steers at
constexpr double kFarthest = 0.8;   // [m] before the passage, where it may begin
constexpr double kBesideIn = 0.03;  // [m] off the axis in the passage, at most, to begin
constexpr double kSlope = 0.5;      // of that allowance with the distance from it
constexpr double kMouth = 0.25;     // [m] before the narrowest place, where the allowance begins to grow
constexpr double kClear = 0.06;     // [m] behind it, beyond which the rear corners are free to swing
constexpr double kSure = 0.12;      // [m] standard deviation of the width, at most, to begin
constexpr double kFacing = 0.5;     // cosine between the robot's heading and the axis, at least, to begin
// Of the robot's width: what has to be free. Echoes of the edges reach into the rest.
constexpr double kMiddle = 0.8;

/// How far [m] along the axis the robot's centre is when its rear corners are free.
double exitOf(const RobotModel& robot) { return robot.length / 2 + kClear * pioneerScale(robot); }

/// Whether something stands in the middle of the way out. Where one edge is no round body but a wall, the
/// axis between both circles leads into it.
bool isBlocked(const Passage& passage, std::span<const SectorHit> hits, const NavigationScene& scene) {
  const RobotModel& robot = *scene.robot;
  const Pose2& pose = scene.self.pose;
  const Vec2 ahead = math::unit(pose.heading);
  const double from = passage.along(pose.position), to = exitOf(robot) + robot.length / 2;
  return std::any_of(hits.begin(), hits.end(), [&](const SectorHit& hit) {
    if (hit.isEmpty()) return false;
    const Vec2 place = pose.position + outOfFrame(ahead, hit.point);
    const double along = passage.along(place);
    return along > from && along < to && std::abs(passage.aside(place)) < kMiddle * robot.width / 2;
  });
}

bool mayBegin(const Passage& passage, const NavigationScene& scene, double widest) {
  const double scale = pioneerScale(*scene.robot), along = passage.along(scene.self.pose.position);
  const double beside = (kBesideIn + kSlope * std::max(0.0, -along / scale - kMouth)) * scale;
  return passage.width > scene.robot->width && passage.width < widest && along < 0.0 &&
         along > -kFarthest * scale && std::abs(passage.aside(scene.self.pose.position)) < beside &&
         dot(passage.axis, math::unit(scene.self.pose.heading)) > kFacing &&
         passage.deviation < kSure * scale;
}

}  // namespace

Passage passageBetween(const EchoCircles::Tracked& left, const EchoCircles::Tracked& right) {
  const EchoCircle &a = left.circle, &b = right.circle;
  const Vec2 across = unitOr(b.centre() - a.centre(), {0.0, -1.0});
  const Vec2 first = a.centre() + across * a.radius(), second = b.centre() - across * b.radius();
  return {(first + second) / 2,
          perp(across),
          dot(second - first, across),
          norm({a.surfaceDeviation(across), b.surfaceDeviation(-across)}),
          left.name,
          right.name};
}

void PassageGuide::update(const EchoCircles& circles, std::span<const SectorHit> hits,
                          std::span<const NarrowGap> gaps, const NavigationScene& scene, double widest,
                          bool may_start) {
  passage_ = present(circles, hits, scene);
  if (passage_ || !may_start) return;
  const Pose2& pose = scene.self.pose;
  const Vec2 ahead = math::unit(pose.heading);
  for (const NarrowGap& gap : gaps) {
    const auto* left = circles.at(pose.position + outOfFrame(ahead, gap.left));
    const auto* right = circles.at(pose.position + outOfFrame(ahead, gap.right));
    if (left == nullptr || right == nullptr || left == right) continue;
    const Passage passage = passageBetween(*left, *right);
    if (!mayBegin(passage, scene, widest) || isBlocked(passage, hits, scene)) continue;
    passage_ = passage;
    return;
  }
}

/// Empty once the robot is through, a circle is gone, or the passage turns out too narrow or blocked.
std::optional<Passage> PassageGuide::present(const EchoCircles& circles, std::span<const SectorHit> hits,
                                             const NavigationScene& scene) const {
  if (!passage_) return {};
  const auto *left = circles.named(passage_->left), *right = circles.named(passage_->right);
  if (left == nullptr || right == nullptr) return {};
  const Passage passage = passageBetween(*left, *right);
  const RobotModel& robot = *scene.robot;
  const bool is_through = passage.along(scene.self.pose.position) > exitOf(robot);
  if (is_through || passage.width < robot.width || isBlocked(passage, hits, scene)) return {};
  return passage;
}

double PassageGuide::direction(Vec2 place, double scale) const {
  return math::angleOf(passage_->axis * (kReach * scale) - perp(passage_->axis) * passage_->aside(place));
}

}  // namespace fulbito
