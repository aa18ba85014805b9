#pragma once

#include "strategies/prediction/ball_prediction.hpp"

namespace fulbito {

/// Estimates the ball's spin, which nobody sees, from the velocities that were seen: robots change the
/// velocity but not the spin, the floor draws the two together, and a wall takes most of the spin toward it.
/// So a ball that was just kicked is known to slide, one on its way for long to roll.
class BallTracker {
 public:
  /// Play begins anew: the next ball that is seen is taken to roll.
  void reset() { known_ = false; }
  /// The ball as seen `dt` [s] after the one before, with its spin.
  BallState update(const BallCourse& course, BallState seen, double dt);

 private:
  BallState last_;
  bool known_ = false;
};

}  // namespace fulbito
