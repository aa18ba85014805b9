// Private header of strategies: not installed.
#pragma once

#include <array>

#include "strategies/libero_pitch.hpp"

namespace fulbito::libero {

/// The ball's spin is not observed but follows from its motion: a kick brings none, the floor brings it up to
/// the speed, a wall takes most of its normal part. This keeps an estimate from tick to tick.
class SpinTracker {
 public:
  /// A play begins with a resting or kicked ball that does not spin yet.
  void reset() { begun_ = false; }
  /// Takes in the ball of one tick; gives it back with its spin.
  BallState update(const Pitch& pitch, BallState seen);

 private:
  bool begun_ = false;
  BallState last_;
};

/// Moves a free ball on by `dt` [s]: sliding, rolling, bounces off walls and corner cuts; the goals are open.
/// Robots are not in its way.
BallState rolledOn(const Pitch& pitch, BallState ball, double dt);

/// Where a free ball will be during the next seconds.
class BallForecast {
 public:
  static constexpr int kSteps = 30;
  static constexpr double kStep = 0.05;  ///< [s]

  void compute(const Pitch& pitch, const BallState& ball);
  /// At `time` [s] from now, held at the horizon of 1.5 s.
  Vec2 at(double time) const;
  /// At step `i` of `kStep`, 0 is now.
  Vec2 sample(int i) const { return points_[static_cast<std::size_t>(i)]; }
  const BallState& now() const { return now_; }
  bool resting() const { return resting_; }

 private:
  std::array<Vec2, kSteps + 1> points_{};
  BallState now_;
  bool resting_ = true;
};

}  // namespace fulbito::libero
