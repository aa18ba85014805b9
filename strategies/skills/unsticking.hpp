#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Notices a robot that is meant to move and does not, and backs it off for a moment. One a robot; to be fed
/// the command that is about to be sent.
class Unsticking {
 public:
  /// `meant`: the robot is meant to move; when it has not for 0.8 s, it backs off for a quarter of a second.
  /// A value: drive so instead.
  std::optional<Twist> update(const RobotState& robot, bool meant, double dt);

 private:
  double held_ = 0.0;  ///< [s] without motion
  double left_ = 0.0;  ///< [s] of backing off
  double speed_ = 0.0;
};

}  // namespace fulbito
