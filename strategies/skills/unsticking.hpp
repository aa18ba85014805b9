#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Detects a robot that is meant to move but does not, and backs it off for a moment. Each robot needs its
/// own; call it with the command that follows.
class Unsticking {
 public:
  /// `meant`: the robot is meant to move. After 0.8 s without motion, it backs off for a quarter of a second.
  /// The result replaces the command; empty: the command stays.
  std::optional<Twist> update(const RobotState& robot, bool meant, double dt);

 private:
  double held_ = 0.0;  ///< [s] without motion
  double left_ = 0.0;  ///< [s] of backing off
  double speed_ = 0.0;
};

}  // namespace fulbito
