#pragma once

#include <optional>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/strategy.hpp"

/// Balls at walls: when a robot spins to kick the ball, and in which sense (docs/skills.md, Spins).
namespace fulbito {

/// Sense of rotation that kicks a ball next to the robot along `wanted`: +1 counter-clockwise, -1 clockwise.
double spinSense(Vec2 robot, Vec2 ball, Vec2 wanted);

/// Limits of a robot's spins at a ball.
struct SpinSettings {
  double reach = 0.075;   ///< [m] centre to centre: a spin begins up to this distance
  double release = 0.10;  ///< [m] centre to centre: a spin ends beyond this distance
  double slow = 0.35;     ///< [m/s] fastest ball for a spin
  double wall = 0.05;     ///< [m] largest gap between wall and a pinned ball
  double longest = 0.6;   ///< [s] longest spin
  double lock_out = 0.5;  ///< [s] least time between two spins
};

/// Spins of one robot: begins, holds and ends them.
class SpinKick {
 public:
  /// Sense of the spin for this tick; empty: no spin. `wanted`: the ball's wanted direction; `allowed`: a new
  /// spin may begin now (no mate in the way).
  std::optional<double> update(const FieldGeometry& field, double ball_radius, const RobotState& robot,
                               const BallState& ball, Vec2 wanted, bool allowed, double dt,
                               const SpinSettings& settings = {});

 private:
  double time_ = 0.0;  ///< [s] time in this spin
  double rest_ = 0.0;  ///< [s] time until the next spin may begin
  double sense_ = 0.0;
};

}  // namespace fulbito
