#pragma once

#include <array>
#include <optional>
#include <span>

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// An interval of a goal's mouth that the ball's centre may pass.
struct MouthInterval {
  double low = 0.0;   ///< [m] y
  double high = 0.0;  ///< [m] y

  /// Width [m] of the interval.
  constexpr double width() const { return high - low; }
};

/// A body in front of the goal.
struct ShotBlocker {
  Vec2 position;           ///< [m] its centre
  double radius = 0.0375;  ///< [m] half the body's width
  Vec2 velocity;           ///< [m/s]
};

/// The model of shots and blockers.
struct ShotModel {
  double ball_radius = 0.0215;  ///< [m]
  double speed = 1.2;           ///< [m/s] speed of the shot
  double acceleration = 6.0;    ///< [m/s^2] of blockers toward the ball
  double reaction = 0.05;       ///< [s] time before blockers start
};

/// Free parts of the opponents' mouth (the goal at +x) as seen from a ball, in order of y. They are the mouth
/// less a ball's radius at each post and less the blockers' shadows (docs/skills.md, Shots).
class FreeMouth {
 public:
  static constexpr std::size_t kMost = 2 * 11 + 1;  ///< most intervals: two full teams of blockers
  /// `ball` is the position [m] of the ball.
  FreeMouth(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
            std::span<const ShotBlocker> blockers);
  /// The free intervals, in order of y.
  std::span<const MouthInterval> intervals() const { return {intervals_.data(), count_}; }

 private:
  void remove(double low, double high);

  std::array<MouthInterval, kMost> intervals_{};
  std::size_t count_ = 0;
};

/// The best target [m] of a shot on the opponents' goal line. It lies in the interval with the widest angle
/// from the ball. The point is its middle, or 60:40 against the motion of the blocker nearest to the goal.
/// Empty if no interval is free.
std::optional<Vec2> bestShot(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
                             std::span<const ShotBlocker> blockers);

}  // namespace fulbito
