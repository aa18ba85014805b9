#include "strategies/prediction/point_track.hpp"

#include <cmath>

namespace fulbito {
namespace {

constexpr int kMemory = 12;        // positions: a fifth of a second at 60 Hz
constexpr double kSurprise = 4.5;  // standard deviations

}  // namespace

void PointTrack::update(Vec2 seen, Vec2 velocity, Vec2 change, double dt) {
  if (count_ == 0) {
    position_ = seen_ = seen;
    velocity_ = velocity;
    count_ = kMemory;
    return;
  }
  const Vec2 predicted = position_ + velocity_ * dt + change * (0.5 * dt * dt);
  velocity_ += change * dt;
  // The camera did not see the body: it repeats the last picture.
  if (seen == seen_) {
    position_ = predicted;
    return;
  }
  seen_ = seen;
  const double n = count_;
  const double alpha = 2.0 * (2.0 * n + 1.0) / ((n + 1.0) * (n + 2.0));
  const double beta = 6.0 / ((n + 1.0) * (n + 2.0));
  const Vec2 surprise = seen - predicted;
  // The variance of the difference between a prediction by this filter and a position is 1 / (1 - alpha).
  const double most = kSurprise * kSurprise * noise_ * noise_ / (1.0 - alpha);
  if (count_ > 1 && squaredNorm(surprise) > most) {
    velocity_ += surprise / dt;
    position_ = seen;
    count_ = 1;
    return;
  }
  position_ = predicted + surprise * alpha;
  velocity_ += surprise * (beta / dt);
  if (count_ < kMemory) ++count_;
}

}  // namespace fulbito
