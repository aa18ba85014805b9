#pragma once

#include <algorithm>

#include "fulbito/models.hpp"

namespace fulbito {

/// Yaw rate of a robot that spins in place, relative to ideal wheels. It is linear in the rim speed between
/// the model's two measured points and constant outside; 1 if the model has no such points. Wheels that roll
/// the same way scrub less: the ratio fades to 1 between spinning in place and turning about a wheel.
class SpinRatio {
 public:
  explicit SpinRatio(const RobotModel& robot);
  /// Whether it is 1 at all speeds.
  bool isOne() const { return slow_ == 1.0 && slope_ == 0.0; }
  /// @param rim_speed  [m/s] >= 0
  double at(double rim_speed) const { return slow_ + slope_ * std::clamp(rim_speed - from_, 0.0, span_); }
  /// The yaw rate [rad/s] that has to be commanded for a body that moves with `motion` to keep its own.
  double commandFor(const Twist& motion) const;
  /// The yaw rate [rad/s] below which a command slows the turn of a body that moves with `motion`. Wheels of
  /// some width have play: between this command and `commandFor`, both edges of a wheel scrub, and none
  /// rolls.
  double slowingCommandFor(const Twist& motion) const;

 private:
  double commandForRims(double turn, double outer_edge, const Twist& motion) const;

  double half_track_ = 0.0;  // [m]
  double edges_ = 0.0;       // wheel width over axle track
  double per_play_ = 0.0;    // half the rims' difference over the driving speed up to which nothing scrubs
  double from_ = 0.0;        // [m/s]
  double span_ = 0.0;        // [m/s]
  double slow_ = 1.0;
  double slope_ = 0.0;  // [s/m]
};

}  // namespace fulbito
