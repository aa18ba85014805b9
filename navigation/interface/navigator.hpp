#pragma once

#include "navigation/interface/guidance.hpp"
#include "navigation/interface/scene.hpp"

namespace fulbito {

/// One navigation method. An instance belongs to one robot and keeps its memory between ticks. Contract:
/// `plan` returns finite numbers for any finite scene, allocates nothing once warm, and reads no clock.
class Navigator {
 public:
  virtual ~Navigator() = default;
  /// Forgets everything: the next call starts a new trial.
  virtual void reset() = 0;
  /// Plans the motion in the present scene. Called once per control tick.
  virtual Guidance plan(const NavigationScene& scene) = 0;
};

}  // namespace fulbito
