#pragma once

#include "navigation/interface/guidance.hpp"
#include "navigation/interface/scene.hpp"

namespace fulbito {

/// One navigation method. A value of this class belongs to one robot and keeps what it must remember between
/// ticks. Contract: `plan` gives finite numbers for any finite scene, allocates nothing once warm, reads no
/// clock.
class Navigator {
 public:
  virtual ~Navigator() = default;
  /// Forgets everything: the next call starts a new trial.
  virtual void reset() = 0;
  /// Looks at the scene and says where to drive; called once a control tick.
  virtual Guidance plan(const NavigationScene& scene) = 0;
};

}  // namespace fulbito
