#include "engine/core/math.hpp"

#include <cmath>

namespace fulbito::math {

double sin(double x) { return std::sin(x); }
double cos(double x) { return std::cos(x); }
double tan(double x) { return std::tan(x); }
SinCos sinCos(double x) { return {std::sin(x), std::cos(x)}; }
double atan2(double y, double x) { return std::atan2(y, x); }
double asin(double x) { return std::asin(x); }
double acos(double x) { return std::acos(x); }
double exp(double x) { return std::exp(x); }
double log(double x) { return std::log(x); }
double pow(double x, double y) { return std::pow(x, y); }

double wrapAngle(double angle) {
  if (angle >= -kPi && angle < kPi) return angle;
  const double turns = std::floor((angle + kPi) / (2.0 * kPi));
  const double wrapped = angle - turns * (2.0 * kPi);
  // Rounding may leave the result a hair outside.
  if (wrapped < -kPi) return wrapped + 2.0 * kPi;
  return wrapped >= kPi ? wrapped - 2.0 * kPi : wrapped;
}

}  // namespace fulbito::math
