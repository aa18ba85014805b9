#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/vec2.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// What a camera makes of the truth, body by body, by random numbers of its own. Where the model has no noise
/// or no drop-outs none is drawn.
class Sensor {
 public:
  Sensor(const SensorModel& model, const Rng& random) : model_(model), random_(random) {}

  /// Whether a body is seen in this tick.
  bool sees() { return !(model_.dropout > 0.0) || random_.uniform() >= model_.dropout; }
  /// Adds noise to a position [m], x before y. @return whether there is any
  bool blur(Vec2& position);
  /// Adds noise to a heading [rad], which stays within -pi ... pi. @return whether there is any
  bool blurHeading(double& heading);

 private:
  SensorModel model_;
  Rng random_;
};

/// Shows pictures some ticks after they were taken; until there are so many, the first one.
template <typename Picture>
class DelayedPictures {
 public:
  explicit DelayedPictures(int ticks) : ring_(static_cast<std::size_t>(ticks) + 1) {}

  /// The same picture for all ticks before this one.
  void fill(const Picture& picture) {
    std::fill(ring_.begin(), ring_.end(), picture);
    taken_ = ring_.size();
  }
  void take(const Picture& picture) { ring_[taken_++ % ring_.size()] = picture; }
  bool empty() const { return taken_ == 0; }
  /// The one that arrives now; one must have been taken.
  const Picture& shown() const { return ring_[(taken_ - 1 - age()) % ring_.size()]; }
  /// How many ticks before the last one it was taken.
  std::size_t age() const { return std::min(taken_, ring_.size()) - 1; }

 private:
  std::vector<Picture> ring_;
  std::size_t taken_ = 0;
};

}  // namespace fulbito
