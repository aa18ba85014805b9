#include "strategies/teams/libero/situation/ball.hpp"

#include <algorithm>

namespace fulbito::libero {
namespace {

constexpr double kResting = 0.02;  // [m/s] resolution: it rolls 3 mm at most

}  // namespace

void BallForecast::take(const BallState& ball, const BallPrediction& way) {
  now_ = ball;
  resting_ = squaredNorm(ball.velocity) < kResting * kResting;
  points_[0] = ball.position;
  if (resting_) {
    points_.fill(ball.position);
  } else {
    way.sample(std::span(points_).subspan(1), kStep);
  }
}

Vec2 BallForecast::at(double time) const {
  const double steps = std::clamp(time / kStep, 0.0, static_cast<double>(kSteps) - 1e-9);
  const auto i = static_cast<std::size_t>(steps);
  const double part = steps - static_cast<double>(i);
  return points_[i] + (points_[i + 1] - points_[i]) * part;
}

}  // namespace fulbito::libero
