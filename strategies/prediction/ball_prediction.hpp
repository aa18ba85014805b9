#pragma once

#include <array>
#include <optional>
#include <span>

#include "fulbito/models.hpp"
#include "fulbito/values.hpp"
#include "strategies/prediction/ball_walls.hpp"

namespace fulbito {

/// What a ball's way depends on beside its state. Made once a match.
struct BallCourse {
  BallModel ball;
  BallWalls walls;
  double restitution_threshold = 0.1;  ///< [m/s] slower impacts do not bounce

  BallCourse() = default;
  BallCourse(const FieldGeometry& field, const BallModel& model, const PhysicsProfile& physics)
      : ball(model), walls(field, model.radius), restitution_threshold(physics.restitution_threshold) {}
};

/// Where the ball will be, if nobody touches it: a chain of stretches of even acceleration (sliding, rolling,
/// resting) between events (the spin has caught up, a bounce, rest), each in closed form, so that the ball at
/// any time costs a handful of multiplications. The model is the engine's own (docs/models.md).
class BallPrediction {
 public:
  /// Where and when the ball passes a line.
  struct Crossing {
    double time = 0.0;  ///< [s] from now
    Vec2 place;         ///< [m] of the ball's centre
    Vec2 velocity;      ///< [m/s]
  };

  /// Predicts `horizon` [s] ahead: beyond, the ball is taken to stay. The spin in `ball` counts (0 means a
  /// ball that slides): give `BallTracker`'s, or the velocity for a ball that rolls.
  void predict(const BallCourse& course, const BallState& ball, double horizon = 3.0);

  Vec2 positionAt(double t) const;   ///< [m] `t` seconds from now, t >= 0
  Vec2 velocityAt(double t) const;   ///< [m/s]
  BallState ballAt(double t) const;  ///< with its spin
  int bouncesBefore(double t) const;
  /// When the ball comes to rest [s], or the horizon where it rolls longer.
  double endOfMotion() const { return stretches_[static_cast<std::size_t>(count_ - 1)].begin; }
  Vec2 endOfWay() const { return stretches_[static_cast<std::size_t>(count_ - 1)].motion.position; }
  /// First passage, at or after `from` [s], of the line through `point` in the direction of its unit
  /// `normal`.
  std::optional<Crossing> crossing(Vec2 point, Vec2 normal, double from = 0.0) const;
  /// Positions at `step`, 2 `step` ... for drawings.
  void sample(std::span<Vec2> points, double step) const;

 private:
  static constexpr int kMaxStretches = 24;

  /// One stretch; the last one lasts for ever.
  struct Stretch {
    double begin = 0.0;  ///< [s] from now
    EvenMotion motion;   ///< time 0 is `begin`
    Vec2 spin;           ///< [m/s] at `begin`
    Vec2 spin_change;    ///< [m/s^2]
    int bounces = 0;     ///< off walls, so far
  };

  const Stretch& stretchAt(double t) const;
  double endOf(int index) const;
  void rest(double time, Vec2 position, int bounces);

  std::array<Stretch, kMaxStretches> stretches_{};
  int count_ = 1;
};

}  // namespace fulbito
