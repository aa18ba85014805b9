#pragma once

#include <numbers>

#include "fulbito/detail/vec2.hpp"

/// Elementary functions with the same bits on every CPU, compiler and optimisation level.
///
/// The C library chooses variants of sin, cos, tan, atan2, asin, acos, exp, log and pow by CPU at run time.
/// They differ in the last bit of a double. The functions here use only basic IEEE operations, square roots
/// and bit casts, in rounding mode "to nearest". Simulation state must not depend on any others;
/// `scripts/check-determinism.sh` forbids the C library's in library sources.
namespace fulbito::math {

inline constexpr double kPi = std::numbers::pi;  ///< the double nearest to pi

/// @{ Within 2 ulp for every finite x [rad]. The reduction of large angles uses as many bits of 2 / pi as
/// needed; |x| >= 2^20 takes about twice the time. NaN and infinity give NaN. sin and tan keep the sign of
/// zero.
double sin(double x);
double cos(double x);  ///< of x [rad]
double tan(double x);  ///< of x [rad]
/// @}

/// Sine and cosine of one angle, bit-identical to `sin` and `cos`, in little more than the time of one.
struct SinCos {
  double sin;  ///< sine
  double cos;  ///< cosine
};
/// Sine and cosine of x [rad]; accuracy and special cases as `sin` and `cos`.
SinCos sinCos(double x);

/// Angle of the point (x, y) [rad], in [-pi, pi], within 2 ulp. Quadrants, zeros and infinities as C Annex F.
double atan2(double y, double x);
/// @{ Inverse sine and cosine [rad], within 2 ulp; NaN outside [-1, 1].
double asin(double x);
double acos(double x);  ///< in [0, pi]
/// @}
/// e to the power of x, within 2 ulp for normal results; overflow to infinity, underflow through subnormals
/// to zero.
double exp(double x);
/// Natural logarithm, within 2 ulp; log(0) = -infinity, NaN below.
double log(double x);
/// x to the power of y, within 2 ulp for normal results; special cases as C Annex F.
double pow(double x, double y);

/// Unit vector at `angle` [rad].
inline Vec2 unit(double angle) {
  const SinCos sc = sinCos(angle);
  return {sc.cos, sc.sin};
}
/// Direction of `v` [rad], in [-pi, pi] (-pi only where v.y is -0); 0 for (0, 0).
inline double angleOf(Vec2 v) { return atan2(v.y, v.x); }

/// `angle` [rad] modulo 2 pi (exact, not the double), in [-pi, pi), within 1 ulp of pi for any angle;
/// unchanged if already there. NaN and infinity give NaN.
double wrapAngle(double angle);

}  // namespace fulbito::math
