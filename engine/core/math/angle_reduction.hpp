#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/core/math/constants.hpp"
#include "engine/core/math/double_double.hpp"

namespace fulbito::math {

/// An angle as quadrant * pi / 2 + rest modulo 2 pi, |rest| <= pi / 4 up to rounding.
struct ReducedAngle {
  unsigned quadrant = 0;  ///< 0 to 3
  DoubleDouble rest;      ///< [rad], to about 2^-66 of its size
};

/// The reduction of any finite |x| >= 1/2, however large. NaN and infinity give a NaN rest.
ReducedAngle reduceByBits(double x);

/// The same result, faster for |x| < 2^20 unless x is close to a multiple of pi / 2 (Cody and Waite, 1980).
inline ReducedAngle reduceAngle(double x) {
  using namespace constants;
  // Adding this leaves the nearest integer in the last bits, in two's complement.
  constexpr double kShift = 0x1.8p52;
  if (!(std::abs(x) < 0x1p20)) return reduceByBits(x);
  const double shifted = x * kTwoOverPi + kShift;
  const double n = shifted - kShift;
  const DoubleDouble start = fastTwoSum(x - n * kHalfPi1, -(n * kHalfPi2));
  // Below this the three parts of pi / 2 are not enough.
  if (std::abs(start.high) < 0x1p-12) [[unlikely]]
    return reduceByBits(x);
  const auto quadrant = static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted)) & 3u;
  return {quadrant, fastTwoSum(start.high, start.low - n * kHalfPi3)};
}

}  // namespace fulbito::math
