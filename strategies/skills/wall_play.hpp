#pragma once

#include <optional>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/strategy.hpp"

/// Balls at walls: when to spin, and which way (docs/skills.md, Spins).
namespace fulbito {

/// Sense of a spin that sends a ball beside the robot along `wanted`: +1 counter-clockwise, -1 clockwise.
double spinSense(Vec2 robot, Vec2 ball, Vec2 wanted);

/// When a robot spins at a ball.
struct SpinSettings {
  double reach = 0.075;   ///< [m] centre to centre, where a spin begins
  double release = 0.10;  ///< [m] where it ends
  double slow = 0.35;     ///< [m/s] a faster ball is left alone
  double wall = 0.05;     ///< [m] of free room between ball and wall up to which the ball counts as pinned
  double longest = 0.6;   ///< [s]
  double lock_out = 0.5;  ///< [s] between two spins
};

/// Spins of one robot: begins, holds and ends them.
class SpinKick {
 public:
  /// Sense of the spin for this tick, or nothing. `wanted`: direction in which the ball shall go; `allowed`:
  /// a new spin may begin now (no mate in the way).
  std::optional<double> update(const FieldGeometry& field, double ball_radius, const RobotState& robot,
                               const BallState& ball, Vec2 wanted, bool allowed, double dt,
                               const SpinSettings& settings = {});

 private:
  double time_ = 0.0;  ///< [s] in this spin
  double rest_ = 0.0;  ///< [s] until the next may begin
  double sense_ = 0.0;
};

}  // namespace fulbito
