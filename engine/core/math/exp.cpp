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
constexpr int kFractionBits = 52;

double twoTo(std::int64_t k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << kFractionBits);
}

/// value * 2^k for value near [1, 2), rounded once where the result is subnormal.
double scaled(double value, std::int64_t k) {
  if (k >= -1022 && k <= 1023) return value * twoTo(k);
  return value * twoTo(k / 2) * twoTo(k - k / 2);
}

// exp(v) = 2^(n / 64) exp(r), where v = n ln(2) / 64 + r.
double expOf(DoubleDouble v) {
  if (v.high > 709.8) return kInfinity;
  if (v.high < -745.2) return 0.0;
  // Adding this leaves the nearest integer in the last bits, in two's complement.
  constexpr double kShift = 0x1.8p52;
  const double shifted = v.high * kSixtyFourOverLn2 + kShift;
  const double n = shifted - kShift;
  const auto steps = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(shifted));
  const double r = (v.high - n * kStepHigh) + (v.low - n * kStepLow);
  const Pair& power = kPowersOfTwo[static_cast<std::size_t>(steps & 63)];
  const double growth = r + r * r * polynomial(kExponential, r);
  return scaled(power.high + power.high * (power.low + growth), steps >> 6);
}

/// The number with its last 27 bits cleared: squares and products with small integers are exact.
double leadingBits(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

/// x = 2^exponent (F + f) with F = 1 + i / 64 next to the significand, so that
/// log(x) = exponent ln(2) + log(F) + log(1 + f / F). Next to x = 1, also from below (exponent -1, F = 2),
/// the first two cancel exactly and only the last is left.
struct LogarithmSteps {
  double exponent;
  double nearest;  ///< F
  double f;
  const Logarithm& entry;  ///< table entry of F
};

LogarithmSteps stepsOf(double x) {
  auto bits = std::bit_cast<std::uint64_t>(x);
  std::int64_t k = -1023;
  if (bits >> kFractionBits == 0) {
    bits = std::bit_cast<std::uint64_t>(x * 0x1p54);
    k -= 54;
  }
  k += static_cast<std::int64_t>(bits >> kFractionBits);
  const auto i = static_cast<std::size_t>((((bits >> (kFractionBits - 7)) & 127u) + 1u) / 2u);
  constexpr std::uint64_t kFractionMask = (std::uint64_t{1} << kFractionBits) - 1;
  const double significand =
      std::bit_cast<double>((bits & kFractionMask) | std::bit_cast<std::uint64_t>(1.0));
  const double nearest = 1.0 + static_cast<double>(i) * 0x1p-6;
  return {static_cast<double>(k), nearest, significand - nearest, kLogarithms[i]};
}

/// log(x) to about 2^-66 of its size, as `pow` multiplies its error by up to 745. The high part has 26 bits.
DoubleDouble preciseLog(double x) {
  const auto [exponent, nearest, f, entry] = stepsOf(x);
  const double u_high = leadingBits(f * entry.inverse);
  const double u_low = (f - u_high * nearest) * entry.inverse;
  const double u = u_high + u_low;
  const DoubleDouble first = fastTwoSum(exponent * kLn2High + entry.high, u_high);
  const DoubleDouble second = fastTwoSum(first.high, -0.5 * u_high * u_high);
  const double linear = u_low * (1.0 - u_high - 0.5 * u_low);
  const double low = (exponent * kLn2Low + entry.low) + (first.low + second.low) +
                     (linear + u * u * u * polynomial(kLogarithm, u));
  const double high = leadingBits(second.high + low);
  return {high, (second.high - high) + low};
}

/// log(x). Where `u` is inexact (F is neither 1 nor 2), the result is at least as large as `u`.
double quickLog(double x) {
  const auto [exponent, nearest, f, entry] = stepsOf(x);
  const double u = f * entry.inverse;
  const double square = u * u;
  const DoubleDouble lead = fastTwoSum(exponent * kLn2High + entry.high, u);
  const double low = (exponent * kLn2Low + entry.low) + lead.low;
  return lead.high + (low + (square * u * polynomial(kLogarithm, u) - 0.5 * square));
}

bool isInteger(double y) { return std::floor(y) == y; }
bool isOdd(double y) { return isInteger(y) && !isInteger(0.5 * y); }

/// pow for x or y among 0, infinity and NaN, but not pow(x, 0) and pow(1, y).
double powOfExtremes(double x, double y) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const double size = std::abs(x);
  if (std::isinf(y)) {
    if (size == 1.0) return 1.0;
    return (size > 1.0) == (y > 0.0) ? kInfinity : 0.0;
  }
  const double result = (size == 0.0) == (y < 0.0) ? kInfinity : 0.0;
  return isOdd(y) ? std::copysign(result, x) : result;
}

}  // namespace

double exp(double x) { return std::isnan(x) ? kNaN : expOf({x, 0.0}); }

double log(double x) {
  if (x > 0.0 && x < kInfinity) return quickLog(x);
  if (x == 0.0) return -kInfinity;
  return x > 0.0 ? x : kNaN;
}

double pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (x == 0.0 || !std::isfinite(x) || !std::isfinite(y)) return powOfExtremes(x, y);
  if (x < 0.0 && !isInteger(y)) return kNaN;
  const double sign = x < 0.0 && isOdd(y) ? -1.0 : 1.0;
  const DoubleDouble logarithm = preciseLog(std::abs(x));
  if (std::abs(y * logarithm.high) > 800.0)
    return sign * ((y > 0.0) == (logarithm.high > 0.0) ? kInfinity : 0.0);
  if (logarithm.high == 0.0) return sign;
  const double y_high = leadingBits(y);
  const DoubleDouble exponent = {y_high * logarithm.high,
                                 y_high * logarithm.low + (y - y_high) * (logarithm.high + logarithm.low)};
  return sign * expOf(exponent);
}

}  // namespace fulbito::math
