#pragma once

#include <algorithm>
#include <array>

#include "strategies/prediction/ball_prediction.hpp"

namespace fulbito::libero {

/// The free ball in the next 1.5 s: the prediction's positions in equal steps, which the skills read many
/// times per tick.
class BallForecast {
 public:
  static constexpr int kSteps = 30;
  static constexpr double kStep = 0.05;  ///< [s] resolution: three ticks
  /// How far a prediction must reach [s] for `take`: a step beyond the last that it samples.
  static double horizon() { return (kSteps + 1) * kStep; }

  /// Stores `ball`, the present ball, and samples its prediction `way`.
  void take(const BallState& ball, const BallPrediction& way);
  /// The position [m] at `time` [s] from now, at most 1.5 s.
  Vec2 at(double time) const;
  /// The position [m] at step `i` of `kStep`; 0 is now.
  Vec2 sample(int i) const { return points_[static_cast<std::size_t>(i)]; }
  const BallState& now() const { return now_; }
  bool resting() const { return resting_; }

 private:
  std::array<Vec2, kSteps + 1> points_{};
  BallState now_;
  bool resting_ = true;
};

inline Vec2 BallForecast::at(double time) const {
  const double steps = std::clamp(time / kStep, 0.0, static_cast<double>(kSteps) - 1e-9);
  const auto i = static_cast<std::size_t>(steps);
  const double part = steps - static_cast<double>(i);
  return points_[i] + (points_[i + 1] - points_[i]) * part;
}

}  // namespace fulbito::libero
