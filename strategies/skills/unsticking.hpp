#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Detects a robot that should move but stands still, and drives it back for a moment. Each robot needs its
/// own instance. Call it every tick with the command that it may replace.
class Unsticking {
 public:
  /// `meant`: the robot should move. After 0.8 s without motion, it drives back for 0.25 s. The result
  /// replaces the command; empty: the command stays.
  std::optional<Twist> update(const RobotState& robot, bool meant, double dt);

 private:
  double held_ = 0.0;  ///< [s] without motion
  double left_ = 0.0;  ///< [s] of backing off
  double speed_ = 0.0;
};

}  // namespace fulbito
