#include <cmath>

#include "engine/core/math/angle_reduction.hpp"
#include "engine/core/math/constants.hpp"
#include "engine/core/math/polynomial.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::math {
namespace {

using namespace constants;

/// Below this sin(x) = tan(x) = x after rounding. Returning x keeps the sign of zero.
constexpr double kTiny = 0x1p-27;

// Leading term and correction apart: their sum is the value, and `tan` needs both.
DoubleDouble sineParts(DoubleDouble r) {
  const double z = r.high * r.high;
  return {r.high, r.high * z * polynomial(kSine, z) + r.low * (1.0 - 0.5 * z)};
}

DoubleDouble cosineParts(DoubleDouble r) {
  const double z = r.high * r.high;
  const double half = 0.5 * z;
  const DoubleDouble lead = fastTwoSum(1.0, -half);
  return {lead.high, lead.low + (z * z * polynomial(kCosine, z) - r.high * r.low)};
}

double sum(DoubleDouble v) { return v.high + v.low; }

ReducedAngle reduce(double x) {
  if (std::abs(x) <= 0.75) return {0, {x, 0.0}};
  return reduceAngle(x);
}

// Both series are cheaper than a mispredicted branch on the quadrant of an arbitrary angle.
SinCos sinCosOf(const ReducedAngle& angle) {
  const double s = sum(sineParts(angle.rest)), c = sum(cosineParts(angle.rest));
  const bool swap = (angle.quadrant & 1u) != 0;
  const double sine = swap ? c : s, cosine = swap ? s : c;
  return {(angle.quadrant & 2u) != 0 ? -sine : sine, ((angle.quadrant + 1u) & 2u) != 0 ? -cosine : cosine};
}

}  // namespace

double sin(double x) {
  if (std::abs(x) < kTiny) return x;
  return sinCosOf(reduce(x)).sin;
}

double cos(double x) { return sinCosOf(reduce(x)).cos; }

SinCos sinCos(double x) {
  if (std::abs(x) < kTiny) return {x, 1.0};
  return sinCosOf(reduce(x));
}

double tan(double x) {
  if (std::abs(x) < kTiny) return x;
  const ReducedAngle angle = reduce(x);
  const DoubleDouble sine_parts = sineParts(angle.rest), cosine_parts = cosineParts(angle.rest);
  const DoubleDouble s = fastTwoSum(sine_parts.high, sine_parts.low);
  const DoubleDouble c = fastTwoSum(cosine_parts.high, cosine_parts.low);
  const bool swap = (angle.quadrant & 1u) != 0;
  const DoubleDouble top = swap ? DoubleDouble{-c.high, -c.low} : s, bottom = swap ? s : c;
  const double quotient = top.high / bottom.high;
  return quotient + (top.low - quotient * bottom.low) / bottom.high;
}

double wrapAngle(double angle) {
  if (angle >= -kPi && angle < kPi) return angle;
  // Most angles are one turn off. The first difference is exact, so there is one rounding. Close to a whole
  // turn, two doubles are too few for 2 pi.
  const double size = std::abs(angle), beyond = size - 2.0 * kPi;
  if (size > kPi && size < 2.5 * kPi && std::abs(beyond) > 0x1p-12)
    return std::copysign(1.0, angle) * (beyond - 2.0 * kPiLow);
  const auto [quadrant, rest] = reduceAngle(angle);
  double whole = 0.0, whole_low = 0.0;
  if (quadrant == 1) whole = kHalfPi, whole_low = kHalfPiLow;
  if (quadrant == 3) whole = -kHalfPi, whole_low = -kHalfPiLow;
  if (quadrant == 2) whole = rest.high < 0.0 ? kPi : -kPi, whole_low = rest.high < 0.0 ? kPiLow : -kPiLow;
  const DoubleDouble wrapped = fastTwoSum(whole, rest.high);
  const double rounded = wrapped.high + (wrapped.low + (whole_low + rest.low));
  // The double kPi lies below pi, so an angle just below pi may round to it.
  return rounded == kPi ? -kPi : rounded;
}

}  // namespace fulbito::math
