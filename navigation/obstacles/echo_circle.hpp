#pragma once

#include <array>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// What is known of a body before any echo is fitted to it.
struct EchoCircleStart {
  Vec2 surface;           ///< [m] a point near its surface
  Vec2 inward;            ///< unit, from there into the body
  double radius = 0.045;  ///< [m] guess of its radius
  double spread = 0.015;  ///< [m] standard deviation of the radius
  double deep = 0.01;     ///< [m] standard deviation of `surface` along `inward`
  double across = 0.03;   ///< [m] the same across it
};

/// A circle that is fitted to the echoes of one body, by a Kalman filter of its centre and radius. A single
/// range has an error of millimetres and no bearing within its cone. Ranges from many places narrow both
/// down: the error of the surface falls with the root of their number where they faced it.
class EchoCircle {
 public:
  explicit EchoCircle(const EchoCircleStart& start);

  Vec2 centre() const { return {state_[0], state_[1]}; }
  double radius() const { return state_[2]; }
  /// Standard deviation [m] of the place of the surface that faces along the unit vector `normal`.
  double surfaceDeviation(Vec2 normal) const;
  /// Adds `variance` [m^2] to the centre's coordinates: the body may have moved.
  void loosen(double variance);

  /// The range that a sonar shall measure.
  struct Expectation {
    double range = 0.0;     ///< [m]
    double variance = 0.0;  ///< [m^2] by what is unknown of the circle; the reading's noise comes on top
    Vec2 way;               ///< unit, from the sonar to the centre
  };
  Expectation expect(Vec2 sonar) const;
  /// Takes in a measured range [m] whose noise has the standard deviation `noise` [m].
  void correct(const Expectation& expected, double range, double noise);

 private:
  using Vec3 = std::array<double, 3>;
  Vec3 times(const Vec3& v) const;

  Vec3 state_;                 ///< [m] x and y of the centre, radius
  std::array<Vec3, 3> error_;  ///< [m^2] covariance
};

}  // namespace fulbito
