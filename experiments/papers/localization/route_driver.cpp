#include "experiments/papers/localization/route_driver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fulbito/models.hpp"

namespace fulbito::localization {
namespace {

constexpr double kTurnGain = 2.5;   // [1/s]
constexpr double kSteerGain = 2.0;  // [1/s]
constexpr double kTurned = 0.009;   // [rad] half a degree; the turn ends at a smaller error
constexpr double kArrived = 0.004;  // [m] the part ends at a smaller distance
constexpr double kSteepest = 0.5;   // [rad] greatest angle of the way back to the line
constexpr double kSlowest = 0.02;   // [m/s] least speed, so that a part ends

/// The speed [m/s] from which the robot stops within `way`, including its reaction time: v t + v^2 / (2 a) =
/// way.
double brakingSpeed(double way, const DriveLimits& limits) {
  const double a = limits.deceleration, t = limits.reaction;
  return a * (std::sqrt(t * t + 2 * way / a) - t);
}

}  // namespace

double turnRateFor(double error, double greatest) {
  return std::clamp(kTurnGain * error, -greatest, greatest);
}

RouteDriver::RouteDriver(std::vector<Vec2> points, const DriveLimits& limits)
    : points_(std::move(points)), limits_(limits) {}

double RouteDriver::headingOfPart() const { return math::angleOf(points_[part_ + 1] - points_[part_]); }

double RouteDriver::left(const Pose2& pose) const {
  return dot(points_[part_ + 1] - pose.position, math::unit(headingOfPart()));
}

Twist RouteDriver::drive(const Pose2& pose) {
  while (!finished()) {
    const double error = math::wrapAngle(headingOfPart() - pose.heading);
    if (turning_ && std::abs(error) > kTurned) return {0.0, turnRateFor(error, limits_.turn_rate)};
    turning_ = false;
    if (left(pose) > kArrived) return along(pose);
    turning_ = true;
    ++part_;
  }
  return {};
}

Twist RouteDriver::along(const Pose2& pose) const {
  const double heading = headingOfPart();
  const double offset = cross(math::unit(heading), pose.position - points_[part_]);
  const double back = std::clamp(-offset / limits_.look_ahead, -kSteepest, kSteepest);
  const double error = math::wrapAngle(heading + back - pose.heading);
  const double braking = brakingSpeed(left(pose), limits_);
  const double speed = std::max(kSlowest, std::min(limits_.speed, braking)) * std::max(0.0, math::cos(error));
  return {speed, std::clamp(kSteerGain * error, -limits_.turn_rate, limits_.turn_rate)};
}

}  // namespace fulbito::localization
