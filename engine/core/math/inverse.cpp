#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/core/math/constants.hpp"
#include "engine/core/math/double_double.hpp"
#include "engine/core/math/polynomial.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::math {
namespace {

using namespace constants;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Keeps quotients and products of the two away from overflow and underflow; the direction is unchanged.
void bringIntoRange(double& large, double& small) {
  if (large == 0.0) {
    large = 1.0;
  } else if (large == kInfinity) {
    small = small == kInfinity ? 1.0 : 0.0;
    large = 1.0;
  } else {
    const double scale = large > 1.0 ? 0x1p-200 : 0x1p200;
    large *= scale;
    small *= scale;
  }
}

// With c = k / 16 near small / large: atan(small / large) = atan(c) + atan((small - c large) / (large + c
// small)). c has few bits, so its product with either half of `large` is exact, and so is the difference next
// to it.
DoubleDouble arcTangent(double small, double large) {
  const double ratio = small / large;
  const auto k = ratio < 0x1p-4 ? std::size_t{0} : (static_cast<std::size_t>(ratio * 32.0) + 1) / 2;
  const double c = static_cast<double>(k) * 0x1p-4;
  const double large_high =
      std::bit_cast<double>(std::bit_cast<std::uint64_t>(large) & ~std::uint64_t{0x7ffffff});
  const double top = (small - c * large_high) - c * (large - large_high);
  const double u = top / (large + c * small);
  const double z = u * u;
  const DoubleDouble angle = fastTwoSum(kArcTangents[k].high, u);
  return {angle.high, angle.low + (kArcTangents[k].low + u * z * polynomial(kArcTangent, z))};
}

/// asin(s) - s for |s| <= 1/2.
double arcSineRest(double s) {
  const double z = s * s;
  return s * z * polynomial(kArcSine, z);
}

/// 2 asin(sqrt((1 - x) / 2)) = acos(x), for 1/2 <= x < 1.
DoubleDouble smallArcCosine(double x) {
  const double square = 0.5 * (1.0 - x);
  const double s = std::sqrt(square);
  const DoubleDouble back = twoProduct(s, s);
  const double root_low = ((square - back.high) - back.low) / (2.0 * s);
  return {2.0 * s, 2.0 * (root_low + arcSineRest(s))};
}

/// (base + base_low) - v, for base >= v.
double difference(double base, double base_low, DoubleDouble v) {
  const DoubleDouble lead = fastTwoSum(base, -v.high);
  return lead.high + (lead.low + (base_low - v.low));
}

}  // namespace

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const double ax = std::abs(x), ay = std::abs(y);
  double large = std::max(ax, ay), small = std::min(ax, ay);
  if (!(large < 0x1p900 && large > 0x1p-700)) bringIntoRange(large, small);
  DoubleDouble angle = arcTangent(small, large);
  const bool steep = ay > ax, backward = std::signbit(x);
  if (steep == backward) angle = {-angle.high, -angle.low};
  double base = steep ? kHalfPi : 0.0, base_low = steep ? kHalfPiLow : 0.0;
  if (backward && !steep) base = kPi, base_low = kPiLow;
  return std::copysign(difference(base, base_low, angle), y);
}

double asin(double x) {
  const double size = std::abs(x);
  if (size < 0x1p-27) return x;
  if (size <= 0.5) return x + arcSineRest(x);
  if (size < 1.0) return std::copysign(difference(kHalfPi, kHalfPiLow, smallArcCosine(size)), x);
  return size == 1.0 ? std::copysign(kHalfPi, x) : kNaN;
}

double acos(double x) {
  const double size = std::abs(x);
  if (size <= 0.5) return difference(kHalfPi, kHalfPiLow, {x, arcSineRest(x)});
  if (size < 1.0) {
    const DoubleDouble angle = smallArcCosine(size);
    return x > 0.0 ? angle.high + angle.low : difference(kPi, kPiLow, angle);
  }
  if (size == 1.0) return x > 0.0 ? 0.0 : kPi;
  return kNaN;
}

}  // namespace fulbito::math
