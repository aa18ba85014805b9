#include "navigation/followers/classic_follower.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kProbe = 0.01;      // [m] along the heading, to measure the field's curvature
constexpr double kPathReach = 0.04;  // [m] look-ahead distance on a path that is treated as a field

}  // namespace

double ClassicFollower::fieldHeading(const Guidance& guidance, Vec2 p) {
  if (guidance.kind == GuidanceKind::kField) return guidance.field->heading(p);
  PathTracker probe = tracker_;
  const PathPlace here = probe.locate(guidance.path, guidance.revision, p);
  return math::angleOf(pointAt(guidance.path, advance(guidance.path, here, kPathReach)) - p);
}

Twist ClassicFollower::follow(const Guidance& guidance, const NavigationScene& scene) {
  const Pose2& pose = scene.self.pose;
  if (guidance.kind != GuidanceKind::kField) tracker_.locate(guidance.path, guidance.revision, pose.position);
  const double wanted = fieldHeading(guidance, pose.position);
  const double ahead = fieldHeading(guidance, pose.position + math::unit(pose.heading) * kProbe);
  const double error = math::wrapAngle(wanted - pose.heading);
  const double bend = math::wrapAngle(ahead - wanted) / kProbe;  // [rad/m] the field's turn along the heading

  const double pull = params_.yaw_gain * std::sqrt(std::abs(error));
  const double track = scene.robot->axle_track, k = std::abs(bend);
  const double by_wheels = (2.0 * scene.robot->maxSpeed() - track * pull) / (2.0 + track * k);
  const double by_grip = k > 1e-6 ? (std::sqrt(pull * pull + 4.0 * params_.turn_limit * k) - pull) / (2.0 * k)
                                  : params_.turn_limit / std::max(pull, 1e-6);
  double v = std::max(0.0, std::min({by_wheels, by_grip, guidance.speed_cap}));
  if (scene.goal.stop) v = std::min(v, 4.0 * distance(pose.position, scene.goal.position));
  return {v, v * bend + (error < 0.0 ? -pull : pull)};
}

}  // namespace fulbito
