#pragma once

#include <memory>
#include <span>

#include "fulbito/world.hpp"

namespace fulbito {

/// The baseline of the benchmark: robots, ball and walls stepped by direct Box2D calls. Fixtures, iterations
/// and drive impulses are those of the engine. It reads poses once per control tick, but checks no commands,
/// reports no contacts and keeps no other state.
class BareLoop {
 public:
  /// @param config  robots, one ball and the field; obstacles are ignored
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
