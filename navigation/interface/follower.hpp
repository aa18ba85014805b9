#pragma once

#include <memory>
#include <vector>

#include "engine/core/base/values.hpp"
#include "navigation/interface/guidance.hpp"
#include "navigation/interface/scene.hpp"

namespace fulbito {

/// Turns guidance into the robot's wanted twist; `limitTwist` and the kinematics come after it.
class Follower {
 public:
  virtual ~Follower() = default;
  virtual void reset() = 0;
  /// Wanted twist, not yet limited. `guidance.kind` is not kWheels (that needs no follower).
  virtual Twist follow(const Guidance& guidance, const NavigationScene& scene) = 0;
};

}  // namespace fulbito
