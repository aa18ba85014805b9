#pragma once

#include "strategies/prediction/ball_prediction.hpp"

namespace fulbito {

/// Estimates the ball's spin, which cannot be observed, from its observed velocities. Robots change the
/// velocity but not the spin, floor friction makes the two equal, and a wall takes most of the spin toward
/// it. So a ball slides after a kick and rolls later.
class BallTracker {
 public:
  /// Starts a new play, in which the first observed ball counts as rolling.
  void reset() { known_ = false; }
  /// Returns the ball with its estimated spin. `seen` is the ball as observed `dt` [s] after the previous
  /// call.
  BallState update(const BallCourse& course, BallState seen, double dt);

 private:
  BallState last_;
  bool known_ = false;
};

}  // namespace fulbito
