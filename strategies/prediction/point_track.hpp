#pragma once

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// Position and velocity of a body from its noisy positions. The gains are those of a straight line fitted to
/// all positions since the last surprise (Brookner, Tracking and Kalman Filtering Made Easy, 1998, section
/// 1.2.10), up to a memory of twelve. A position that the noise does not explain begins a new line, so that
/// the filter follows a kick at once.
class PointTrack {
 public:
  /// @param noise  [m] standard deviation of each coordinate, greater than 0
  explicit PointTrack(double noise = 1.0) : noise_(noise) {}
  /// Forgets the past: the next position and velocity count as exact.
  void reset() { count_ = 0; }
  /// Takes the position `seen` [m], `dt` [s] after the last one. `velocity` [m/s] is used after a reset.
  /// `change` [m/s^2] is the body's known acceleration, such as the drag of a rolling ball.
  void update(Vec2 seen, Vec2 velocity, Vec2 change, double dt);

  Vec2 position() const { return position_; }  ///< [m]
  Vec2 velocity() const { return velocity_; }  ///< [m/s]
  /// Whether the last position was a surprise: something hit the body.
  bool surprised() const { return count_ == 1; }

 private:
  double noise_;
  int count_ = 0;  ///< positions since the last surprise; 0: none yet
  Vec2 position_, velocity_, seen_;
};

}  // namespace fulbito
