#include "engine/core/math/angle_reduction.hpp"

#include <bit>
#include <cstdint>
#include <limits>

#include "engine/core/math/constants.hpp"

namespace fulbito::math {
namespace {

using namespace constants;

__extension__ using Wide = unsigned __int128;

constexpr int kFractionBits = 52;
constexpr std::uint64_t kFractionMask = (std::uint64_t{1} << kFractionBits) - 1;

/// 64 bits of 2 / pi (and the zeros before it) from bit `position` on.
std::uint64_t bitsFrom(unsigned position) {
  const unsigned word = position / 64, shift = position % 64;
  const std::uint64_t high = kTwoOverPiBits[word] << shift;
  return shift == 0 ? high : high | (kTwoOverPiBits[word + 1] >> (64 - shift));
}

/// The binary fraction that these 128 bits after the point are, as a sum of two doubles.
DoubleDouble toDoubles(Wide bits) {
  const auto top = static_cast<std::uint64_t>(bits >> 64);
  const int zeros =
      top != 0 ? std::countl_zero(top) : 64 + std::countl_zero(static_cast<std::uint64_t>(bits));
  const Wide shifted = bits << zeros;
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - zeros) << kFractionBits);
  const auto first = static_cast<std::uint64_t>(shifted >> 75);
  const auto second = static_cast<std::uint64_t>(shifted >> 22) & ((std::uint64_t{1} << 53) - 1);
  return {static_cast<double>(first) * 0x1p-53 * scale, static_cast<double>(second) * 0x1p-106 * scale};
}

}  // namespace

// Payne and Hanek (SIGNUM Newsletter 18, 1983): of the product x * 2 / pi only the bits from weight 2
// downward matter, so the bits of 2 / pi that give whole multiples of four quadrants are never used.
ReducedAngle reduceByBits(double x) {
  const auto raw = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<unsigned>(raw >> kFractionBits) & 0x7ff;
  if (biased == 0x7ff) return {0, {std::numeric_limits<double>::quiet_NaN(), 0.0}};
  const std::uint64_t mantissa = (raw & kFractionMask) | (std::uint64_t{1} << kFractionBits);
  const unsigned first_bit = biased - (1023 + kFractionBits) + 62;

  const Wide low = Wide{mantissa} * bitsFrom(first_bit + 128);
  const Wide middle = Wide{mantissa} * bitsFrom(first_bit + 64) + (low >> 64);
  const std::uint64_t high = mantissa * bitsFrom(first_bit) + static_cast<std::uint64_t>(middle >> 64);

  auto quadrant = static_cast<unsigned>(high >> 62);
  Wide fraction = (Wide{high} << 66) | (Wide{static_cast<std::uint64_t>(middle)} << 2) |
                  (static_cast<std::uint64_t>(low) >> 62);
  const bool beyond_half = (fraction >> 127) != 0;
  if (beyond_half) {
    ++quadrant;
    fraction = -fraction;
  }
  const DoubleDouble turns = toDoubles(fraction);
  DoubleDouble rest = twoProduct(turns.high, kHalfPi);
  rest.low += turns.high * kHalfPiLow + turns.low * kHalfPi;
  rest = fastTwoSum(rest.high, rest.low);
  const bool negative = (raw >> 63) != 0;
  if (beyond_half != negative) rest = {-rest.high, -rest.low};
  return {(negative ? 0u - quadrant : quadrant) & 3u, rest};
}

}  // namespace fulbito::math
