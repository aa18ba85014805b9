#pragma once

#include <cstddef>
#include <vector>

#include "fulbito/models.hpp"

namespace fulbito::localization {

/// How fast a robot drives its route.
struct DriveLimits {
  double speed = 0.3;         ///< [m/s]
  double deceleration = 0.3;  ///< [m/s^2] before the end of a part
  double reaction = 0.1;      ///< [s] from a pose to the resulting speed
  double turn_rate = 0.9;     ///< [rad/s]
  double sweep_rate = 0.35;   ///< [rad/s] during a sweep
  double look_ahead = 0.35;   ///< [m] distance in which the robot aims back at the line
};

/// Turn rate [rad/s] toward a heading that is `error` [rad] away; it is smaller for small errors.
double turnRateFor(double error, double greatest);

/// Drives along a chain of straight parts and turns in place between them. It uses only the present pose, so
/// a jump of the pose is just a new distance from the line.
class RouteDriver {
 public:
  RouteDriver(std::vector<Vec2> points, const DriveLimits& limits);

  /// The wanted motion at `pose`.
  Twist drive(const Pose2& pose);
  bool finished() const { return part_ + 1 >= points_.size(); }
  /// Index of the point at which the present part begins.
  std::size_t part() const { return part_; }
  const std::vector<Vec2>& points() const { return points_; }

 private:
  Twist along(const Pose2& pose) const;
  double headingOfPart() const;
  double left(const Pose2& pose) const;

  std::vector<Vec2> points_;
  DriveLimits limits_;
  std::size_t part_ = 0;
  bool turning_ = true;
};

}  // namespace fulbito::localization
