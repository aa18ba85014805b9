#pragma once

#include <memory>

#include "navigation/followers/wall_escape.hpp"
#include "navigation/interface/follower.hpp"
#include "navigation/interface/navigator.hpp"

namespace fulbito {

/// One robot's navigation stage: navigator, follower, escape from walls, limiter and kinematics in one call a
/// tick. Methods that control the wheels themselves get neither follower nor escape.
class Pilot {
 public:
  Pilot(std::unique_ptr<Navigator> navigator, std::unique_ptr<Follower> follower, bool wall_escape = true);
  /// Forgets everything: the next tick starts a new trial.
  void reset();
  /// Wheel speeds for this tick, within the robot's limits and always finite.
  WheelSpeeds drive(const NavigationScene& scene);
  /// What the navigator wanted at the last tick.
  const Guidance& guidance() const { return guidance_; }

 private:
  std::unique_ptr<Navigator> navigator_;
  std::unique_ptr<Follower> follower_;
  bool wall_escape_;  ///< whether the robot gets away from walls that leave it no room to turn
  WallEscape escape_;
  Guidance guidance_;
};

}  // namespace fulbito
