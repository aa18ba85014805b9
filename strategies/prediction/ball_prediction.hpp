#pragma once

#include <array>
#include <optional>
#include <span>

#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "strategies/prediction/ball_walls.hpp"

namespace fulbito {

/// The constants that a ball's path depends on, apart from its state. Made once per match.
struct BallCourse {
  BallModel ball;
  BallWalls walls;
  double restitution_threshold = 0.1;  ///< [m/s] the ball does not bounce at slower impacts

  BallCourse() = default;
  BallCourse(const FieldGeometry& field, const BallModel& model, const PhysicsProfile& physics)
      : ball(model), walls(field, model.radius), restitution_threshold(physics.restitution_threshold) {}
};

/// The future motion of the ball if no robot touches it. It is a chain of stretches of constant acceleration
/// (sliding, rolling, resting) between events (rolling begins, a bounce, rest). Each stretch has a closed
/// form, so the ball's state at any time takes a few multiplications. The model is the engine's own
/// (docs/models.md).
class BallPrediction {
 public:
  static constexpr double kHorizon = 3.0;  ///< [s] how far a prediction reaches by default

  /// The time and place at which the ball crosses a line.
  struct Crossing {
    double time = 0.0;  ///< [s] from now
    Vec2 place;         ///< [m] position of the ball's centre
    Vec2 velocity;      ///< [m/s]
  };

  /// Predicts the motion for the next `horizon` [s]; after that the predicted ball stays where it is.
  /// `ball.spin` must be valid: use the spin of `BallTracker`, or the velocity for a rolling ball. Spin 0
  /// means that the ball slides.
  void predict(const BallCourse& course, const BallState& ball, double horizon = kHorizon);

  Vec2 positionAt(double t) const;   ///< [m] `t` seconds from now, t >= 0
  Vec2 velocityAt(double t) const;   ///< [m/s]
  BallState ballAt(double t) const;  ///< the same with the spin
  /// Number of bounces off walls before `t` [s].
  int bouncesBefore(double t) const;
  /// Time [s] at which the ball comes to rest, or the horizon if it rolls longer.
  double endOfMotion() const { return stretches_[static_cast<std::size_t>(count_ - 1)].begin; }
  /// [m] The ball's position at `endOfMotion`.
  Vec2 endOfWay() const { return stretches_[static_cast<std::size_t>(count_ - 1)].motion.position; }
  /// The first crossing, at or after `from` [s], of the line through `point` with the unit normal `normal`,
  /// in the direction of the normal.
  std::optional<Crossing> crossing(Vec2 point, Vec2 normal, double from = 0.0) const;
  /// Positions at `step`, 2 `step` ... [s], for drawings.
  void sample(std::span<Vec2> points, double step) const;

 private:
  static constexpr int kMaxStretches = 24;

  /// One stretch. The last one lasts forever.
  struct Stretch {
    double begin = 0.0;  ///< [s] from now
    EvenMotion motion;   ///< time 0 is `begin`
    Vec2 spin;           ///< [m/s] at `begin`
    Vec2 spin_change;    ///< [m/s^2]
    int bounces = 0;     ///< bounces off walls so far
  };

  const Stretch& stretchAt(double t) const;
  double endOf(int index) const;
  void rest(double time, Vec2 position, int bounces);

  std::array<Stretch, kMaxStretches> stretches_{};
  int count_ = 1;
};

}  // namespace fulbito
