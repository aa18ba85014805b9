#pragma once

#include <memory>
#include <span>

#include "fulbito/world.hpp"

namespace fulbito {

/// The yardstick: robots, ball and walls stepped by direct Box2D calls. The same fixtures, iterations and
/// drive impulses as the engine's, poses read once a control tick; no commands checked, no contacts reported,
/// no state kept but Box2D's.
class BareLoop {
 public:
  /// @param config  robots, one ball and the field; obstacles are not taken
  explicit BareLoop(const WorldConfig& config);
  BareLoop(BareLoop&&) noexcept;
  ~BareLoop();

  void step(std::span<const WheelSpeeds> commands);
  std::span<const Pose2> robots() const;
  Vec2 ball() const;
  int touchingPairs() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
