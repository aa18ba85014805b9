#pragma once

#include "strategies/prediction/ball_prediction.hpp"

namespace fulbito {

/// Estimates the ball's unobserved spin from its observed velocities. Robots change the velocity but not the
/// spin, the floor draws the two together, and a wall takes most of the spin toward it. So a ball slides
/// after a kick and rolls later.
class BallTracker {
 public:
  /// A new play begins: the next observed ball counts as rolling.
  void reset() { known_ = false; }
  /// The ball with its spin, from the ball as seen `dt` [s] after the previous call.
  BallState update(const BallCourse& course, BallState seen, double dt);

 private:
  BallState last_;
  bool known_ = false;
};

}  // namespace fulbito
