#pragma once

#include "fulbito/models.hpp"

namespace fulbito {

/// Pose and velocity of an own robot from its wheels, which it knows exactly, and its noisy poses. The wheels
/// give the motion; the poses correct the drift of slipping and pushed robots.
class WheelTrack {
 public:
  WheelTrack() = default;
  /// @param position_noise  [m] standard deviation of each coordinate
  /// @param heading_noise   [rad] standard deviation of the heading
  WheelTrack(const RobotModel& robot, double position_noise, double heading_noise)
      : robot_(robot), position_noise_(position_noise), heading_noise_(heading_noise) {}
  /// Forgets the past: the next pose counts as exact.
  void reset() { known_ = false; }
  /// Returns the estimate for the state `seen`, `dt` [s] after the last one.
  RobotState update(const RobotState& seen, double dt);

 private:
  RobotModel robot_;
  double position_noise_ = 0.0, heading_noise_ = 0.0;
  RobotState last_;
  Pose2 seen_;
  bool known_ = false;
};

}  // namespace fulbito
