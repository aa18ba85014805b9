#pragma once

#include <array>
#include <optional>
#include <span>

#include "engine/core/models/field_geometry.hpp"
#include "strategies/prediction/ball_prediction.hpp"

namespace fulbito {

/// A stretch of a goal's mouth where the ball's centre may pass.
struct MouthInterval {
  double low = 0.0;   ///< [m] y
  double high = 0.0;  ///< [m] y

  constexpr double width() const { return high - low; }
  constexpr double middle() const { return 0.5 * (low + high); }
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
  double spread = 0.07;         ///< [rad] standard deviation of where shots go: 4 degrees, chosen
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

/// A shot that could be taken.
struct Shot {
  Vec2 aim;                  ///< [m] on the goal line
  double half_angle = 0.0;   ///< [rad] half of the free interval as the ball sees it
  double probability = 0.0;  ///< of a goal when it is struck there
};

/// The best shot at the opponents' goal: into the interval that is widest as the ball sees it, at its middle,
/// or 60:40 against the motion of the nearest blocker to the goal. Empty when nothing is free.
std::optional<Shot> bestShot(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
                             std::span<const ShotBlocker> blockers);

/// Chance that a shot with a standard deviation of `spread` [rad] stays within +-`half_angle` [rad].
double chanceWithin(double half_angle, double spread);

/// A shot off a side wall.
struct BankShot {
  Vec2 direction;      ///< unit, of the ball at the strike
  Vec2 bounce;         ///< [m] where the ball's centre is at the wall
  double miss = 0.0;   ///< [m] from the target, sideways, by the prediction
  double speed = 0.0;  ///< [m/s] at the target
};

/// How a ball has to be struck with `speed` [m/s] to come to `target` off one side wall (`upper`: the one at
/// +y). The target is mirrored behind the wall at 1 / e times its distance to it, as a bounce keeps e of the
/// speed toward the wall, and farther on by what the wall's friction takes along it; then the prediction
/// corrects the aim for the ball's curve while its spin settles. Empty when the ball does not get there off
/// that wall.
std::optional<BankShot> bankShot(const BallCourse& course, const FieldGeometry& field, Vec2 ball, Vec2 target,
                                 bool upper, double speed);

}  // namespace fulbito
