#include "navigation/followers/speed_profile.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kCrawl = 0.01;  // [m/s] least speed inside a path

double acceleration(const SpeedLimits& limits, double curvature) {
  return limits.acceleration / (1.0 + 0.5 * limits.axle_track * std::abs(curvature));
}

}  // namespace

SpeedLimits speedLimits(const RobotModel& robot, double acceleration_share, double lateral_share) {
  SpeedLimits limits;
  limits.max_speed = robot.maxSpeed();
  limits.acceleration = acceleration_share * robot.wheel_acceleration;
  limits.lateral = lateral_share * robot.lateral_grip;
  limits.axle_track = robot.axle_track;
  return limits;
}

void pathCurvature(std::span<const Vec2> path, std::span<double> curvature) {
  const std::size_t count = path.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t reach = std::min({std::size_t{2}, i, count - 1 - i});
    const Vec2 a = path[i] - path[i - reach], b = path[i + reach] - path[i],
               c = path[i + reach] - path[i - reach];
    const double product = norm(a) * norm(b) * norm(c);
    curvature[i] = product > 1e-15 ? 2.0 * cross(a, b) / product : 0.0;
  }
}

double timePath(std::span<const Vec2> path, std::span<const double> curvature, const SpeedLimits& limits,
                std::span<double> speeds) {
  const std::size_t count = path.size();
  if (count == 0) return 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double k = std::abs(curvature[i]);
    const double by_wheel = 2.0 * limits.max_speed / (2.0 + limits.axle_track * k);
    const double by_grip = k > 1e-9 ? std::sqrt(limits.lateral / k) : by_wheel;
    speeds[i] = std::max(kCrawl, std::min(by_wheel, by_grip));
  }
  speeds[0] = std::max(kCrawl, std::min(speeds[0], limits.start_speed));
  for (std::size_t i = 1; i < count; ++i) {
    const double ds = distance(path[i - 1], path[i]);
    const double reach = speeds[i - 1] * speeds[i - 1] + 2.0 * acceleration(limits, curvature[i - 1]) * ds;
    speeds[i] = std::min(speeds[i], std::sqrt(reach));
  }
  speeds[count - 1] = std::min(speeds[count - 1], limits.end_speed);
  double time = 0.0;
  for (std::size_t i = count - 1; i-- > 0;) {
    const double ds = distance(path[i], path[i + 1]);
    const double reach = speeds[i + 1] * speeds[i + 1] + 2.0 * acceleration(limits, curvature[i + 1]) * ds;
    speeds[i] = std::min(speeds[i], std::sqrt(reach));
    time += 2.0 * ds / std::max(2e-3, speeds[i] + speeds[i + 1]);
  }
  return time;
}

}  // namespace fulbito
