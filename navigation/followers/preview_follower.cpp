#include "navigation/followers/preview_follower.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"
#include "navigation/followers/limiter.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kFieldPoints = 40;
constexpr double kSpacing = 0.0125;          // [m] between preview points
constexpr std::size_t kMaxPathPoints = 800;  // 10 m at that spacing
constexpr std::size_t kReserve = kMaxPathPoints + 8;
constexpr double kUrgentYaw = 0.3;  // share of the turn acceleration that stays while a speed cap brakes
constexpr double kAtGoal = 0.95;    // share of the goal's tolerance, where the robot turns in place
constexpr double kSlow = 0.08;      // [m/s] a faster robot must brake before it turns in place

}  // namespace

PreviewFollower::PreviewFollower(PreviewParams params) : params_(params) {
  points_.reserve(kReserve);
  curvature_.reserve(kReserve);
  speeds_.reserve(kReserve);
}

void PreviewFollower::reset() {
  tracker_.reset();
  cached_ = false;
  started_ = false;
  spinning_ = false;
}

Twist PreviewFollower::follow(const Guidance& guidance, const NavigationScene& scene) {
  if (scene.goal.heading && slowAtGoal(scene)) {
    started_ = true;
    spinning_ = false;
    return {0.0, params_.yaw_gain * math::wrapAngle(*scene.goal.heading - scene.self.pose.heading)};
  }
  const double speed = std::max(0.0, bodyTwist(scene.self).linear);
  const double reach = params_.lookahead + params_.lookahead_time * speed;
  const bool timed = guidance.kind == GuidanceKind::kTimedPath;
  Ahead ahead = guidance.kind == GuidanceKind::kField ? aheadOnField(guidance, scene, speed, reach)
                                                      : aheadOnPath(guidance, scene, speed, reach);
  ahead.speed = std::min(ahead.speed, guidance.speed_cap);
  if (scene.goal.stop) {
    const double left =
        std::max(0.0, distance(scene.self.pose.position, scene.goal.position) - scene.goal.tolerance / 2);
    ahead.speed = std::min(ahead.speed,
                           stoppingSpeed(params_.acceleration_share * scene.robot->wheel_acceleration, left));
  }
  Twist wanted = steer(ahead, scene, speed, timed);
  if (guidance.speed_cap < speed) {
    // A speed cap is urgent. The limiter serves the yaw rate first, so its change is limited here.
    const double swing = kUrgentYaw * scene.robot->turnAcceleration() * scene.dt;
    const double yaw_rate = scene.self.angular_velocity;
    wanted.angular = std::clamp(wanted.angular, yaw_rate - swing, yaw_rate + swing);
  }
  return wanted;
}

bool PreviewFollower::slowAtGoal(const NavigationScene& scene) const {
  const NavigationGoal& goal = scene.goal;
  return distance(scene.self.pose.position, goal.position) < kAtGoal * goal.tolerance &&
         std::abs(bodyTwist(scene.self).linear) < kSlow;
}

PreviewFollower::Ahead PreviewFollower::aheadOnField(const Guidance& guidance, const NavigationScene& scene,
                                                     double speed, double reach) {
  points_.clear();
  Vec2 p = scene.self.pose.position;
  points_.push_back(p);
  bool arrived = false;
  Vec2 step{};
  for (std::size_t i = 0; i < kFieldPoints; ++i) {
    if (!arrived) {
      const Vec2 half = p + math::unit(guidance.field->heading(p)) * (kSpacing / 2);
      step = math::unit(guidance.field->heading(half)) * kSpacing;
    }
    p += step;
    points_.push_back(p);
    // Beyond the goal the field turns back toward it, so the preview continues straight.
    arrived = arrived || distance(p, scene.goal.position) < kSpacing;
  }
  timeCached(scene);
  const double from = std::min(speed * scene.dt / kSpacing, static_cast<double>(kFieldPoints - 1));
  const auto index = static_cast<std::size_t>(from);
  const double part = from - static_cast<double>(index);
  const double allowed = speeds_[index] + part * (speeds_[index + 1] - speeds_[index]);
  return {pointAt(points_, advance(points_, {}, reach)), allowed};
}

PreviewFollower::Ahead PreviewFollower::aheadOnPath(const Guidance& guidance, const NavigationScene& scene,
                                                    double speed, double reach) {
  const bool timed = guidance.kind == GuidanceKind::kTimedPath;
  if (!timed && (!cached_ || cached_revision_ != guidance.revision)) cachePath(guidance, scene);
  const std::span<const Vec2> path = timed ? guidance.path : std::span<const Vec2>(points_);
  const std::span<const double> speeds = timed ? guidance.speeds : std::span<const double>(speeds_);
  const PathPlace here = tracker_.locate(path, guidance.revision, scene.self.pose.position);
  const PathPlace next = advance(path, here, std::max(speed, 0.05) * scene.dt);
  const double allowed =
      speeds[next.segment] + next.fraction * (speeds[next.segment + 1] - speeds[next.segment]);
  const PathPlace aim = advance(path, here, reach);
  Vec2 target = pointAt(path, aim);
  // Extend a path that ends within reach in its last direction. Otherwise the robot would steer at a point
  // beside it.
  const double missing = reach - distance(pointAt(path, here), target);
  if (aim.segment + 2 >= path.size() && aim.fraction >= 1.0 && missing > 0.0) {
    target +=
        unitOr(path[path.size() - 1] - path[path.size() - 2], math::unit(scene.self.pose.heading)) * missing;
  }
  return {target, allowed};
}

void PreviewFollower::cachePath(const Guidance& guidance, const NavigationScene& scene) {
  points_.clear();
  PathPlace place{};
  points_.push_back(guidance.path.front());
  while (points_.size() < kMaxPathPoints) {
    place = advance(guidance.path, place, kSpacing);
    points_.push_back(pointAt(guidance.path, place));
    if (place.segment + 2 >= guidance.path.size() && place.fraction >= 1.0) break;
  }
  timeCached(scene);
  cached_ = true;
  cached_revision_ = guidance.revision;
}

void PreviewFollower::timeCached(const NavigationScene& scene) {
  curvature_.resize(points_.size());
  pathCurvature(points_, curvature_);
  speeds_.assign(points_.size(), 0.0);
  SpeedLimits limits = speedLimits(*scene.robot, params_.acceleration_share, params_.lateral_share);
  // The profile limits braking only. The limiter limits acceleration.
  limits.start_speed = 1e9;
  timePath(points_, curvature_, limits, speeds_);
}

Twist PreviewFollower::steer(const Ahead& ahead, const NavigationScene& scene, double speed, bool timed) {
  const Vec2 to_target = ahead.target - scene.self.pose.position;
  const double gap = std::max(norm(to_target), 1e-3);
  const double error = math::wrapAngle(math::angleOf(to_target) - scene.self.pose.heading);
  if (!started_) {
    started_ = true;
    spinning_ = std::abs(error) > params_.spin_above && speed < 0.05;
  }
  if (spinning_ && std::abs(error) < params_.spin_until) spinning_ = false;
  if (spinning_ || std::abs(error) > math::kPi / 2) return {0.0, params_.yaw_gain * error};

  const math::SinCos sc = math::sinCos(error);
  Twist wanted;
  wanted.linear = ahead.speed * (timed ? sc.cos : sc.cos * sc.cos);
  wanted.angular = std::max(params_.yaw_gain, 2.0 * speed / gap) * sc.sin;
  const double grip = 0.9 * scene.robot->lateral_grip;
  const double limit = grip / std::max(speed, 0.15);
  if (std::abs(wanted.angular) > limit) {
    wanted.linear = std::min(wanted.linear, grip / std::abs(wanted.angular));
    wanted.angular = std::clamp(wanted.angular, -limit, limit);
  }
  return wanted;
}

}  // namespace fulbito
