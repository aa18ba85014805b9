#pragma once

#include <array>

#include "strategies/prediction/ball_prediction.hpp"

namespace fulbito::libero {

/// Where a free ball will be during the next seconds: the prediction's way in even steps, to which the skills
/// come back many times a tick.
class BallForecast {
 public:
  static constexpr int kSteps = 30;
  static constexpr double kStep = 0.05;  ///< [s]

  /// `ball` is the ball now, `way` its prediction.
  void take(const BallState& ball, const BallPrediction& way);
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
