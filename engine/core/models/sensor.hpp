#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/vec2.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// A camera's errors: adds noise and drop-outs to the true state, body by body, with its own random numbers.
/// It draws none for noise or drop-outs that the model does not have.
class Sensor {
 public:
  Sensor(const SensorModel& model, const Rng& random) : model_(model), random_(random) {}

  /// Whether a body is seen in this tick.
  bool sees() { return !(model_.dropout > 0.0) || random_.uniform() >= model_.dropout; }
  /// Adds noise to a position [m], x before y. @return whether the model has any
  bool blur(Vec2& position);
  /// Adds noise to a heading [rad], which stays within -pi ... pi. @return whether the model has any
  bool blurHeading(double& heading);

 private:
  SensorModel model_;
  Rng random_;
};

/// Shows each picture a fixed number of ticks after it was taken; before that, the first one.
template <typename Picture>
class DelayedPictures {
 public:
  explicit DelayedPictures(int ticks) : ring_(static_cast<std::size_t>(ticks) + 1) {}

  /// Sets the picture of all ticks before the next one.
  void fill(const Picture& picture) {
    std::fill(ring_.begin(), ring_.end(), picture);
    taken_ = ring_.size();
  }
  void take(const Picture& picture) { ring_[taken_++ % ring_.size()] = picture; }
  bool empty() const { return taken_ == 0; }
  /// The picture that arrives in this tick. Requires that one was taken.
  const Picture& shown() const { return ring_[(taken_ - 1 - age()) % ring_.size()]; }
  /// Number of ticks between the shown picture and the newest one.
  std::size_t age() const { return std::min(taken_, ring_.size()) - 1; }

 private:
  std::vector<Picture> ring_;
  std::size_t taken_ = 0;
};

}  // namespace fulbito
