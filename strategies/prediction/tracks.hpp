#pragma once

#include <array>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/point_track.hpp"
#include "strategies/prediction/wheel_track.hpp"

namespace fulbito {

/// The bodies from noisy observations (`MatchInfo::position_noise`): own robots by their wheels, opponents
/// and ball by fitted lines. Exact observations need no work.
class Tracks {
 public:
  Tracks() = default;
  explicit Tracks(const MatchInfo& info);
  /// Forgets the past, for the start of a new play.
  void reset();
  /// Whether observations are noisy.
  bool isNeeded() const { return needed_; }
  /// Replaces the robots of `seen` by their estimates.
  void follow(Observation& seen);
  /// Returns the ball's estimate. `drag` [m/s^2] is its deceleration.
  BallState follow(BallState ball, double drag, double dt);

 private:
  bool needed_ = false;
  std::array<WheelTrack, kMaxTeamSize> own_;
  std::array<PointTrack, kMaxTeamSize> opponents_;
  PointTrack ball_;
};

}  // namespace fulbito
