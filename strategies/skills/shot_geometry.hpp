#pragma once

#include <array>
#include <optional>
#include <span>

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// A stretch of a goal's mouth where the ball's centre may pass.
struct MouthInterval {
  double low = 0.0;   ///< [m] y
  double high = 0.0;  ///< [m] y

  constexpr double width() const { return high - low; }
};

/// Something that stands before the goal.
struct ShotBlocker {
  Vec2 position;
  double radius = 0.0375;  ///< [m] half a body
  Vec2 velocity;           ///< [m/s]
};

/// How shots are judged.
struct ShotModel {
  double ball_radius = 0.0215;  ///< [m]
  double speed = 1.2;           ///< [m/s] of the shot
  double acceleration = 6.0;    ///< [m/s^2] of blockers on their way to the ball
  double reaction = 0.05;       ///< [s] before they start
};

/// Free parts of the opponents' mouth (the goal at +x) as seen from a ball: the mouth less a ball's radius at
/// each post, less the blockers' shadows (docs/skills.md, Shots). In order of y.
class FreeMouth {
 public:
  static constexpr std::size_t kMost = 2 * 11 + 1;
  FreeMouth(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
            std::span<const ShotBlocker> blockers);
  std::span<const MouthInterval> intervals() const { return {intervals_.data(), count_}; }

 private:
  void remove(double low, double high);

  std::array<MouthInterval, kMost> intervals_{};
  std::size_t count_ = 0;
};

/// Where on the opponents' goal line [m] a shot is best aimed: into the interval that is widest as the ball
/// sees it, at its middle, or 60:40 against the motion of the nearest blocker to the goal. Empty when nothing
/// is free.
std::optional<Vec2> bestShot(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
                             std::span<const ShotBlocker> blockers);

}  // namespace fulbito
