#include "strategies/teams/libero/situation/ball.hpp"

#include <span>

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

}  // namespace fulbito::libero
