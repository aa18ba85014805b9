#include "engine/core/models/wheel_pair.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::array kValues{0.0, -0.0, 1.0, -1.0, 0.3, -2.5, 1e-310, kInfinite, -kInfinite};

/// Whether the pair has these values, bit by bit: 0 differs from -0.
bool holds(WheelPair pair, double left, double right) {
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
  };
  return same(pair.left(), left) && same(pair.right(), right);
}

double clamped(double value, double most) { return std::clamp(value, -most, most); }

}  // namespace

TEST_CASE("a pair computes for each wheel what its number alone would give", "[unit]") {
  for (const double a : kValues) {
    for (const double b : kValues) {
      CAPTURE(a, b);
      const WheelPair x(a, b), y(b, 0.7);
      CHECK(holds(x + y, a + b, b + 0.7));
      CHECK(holds(x - y, a - b, b - 0.7));
      CHECK(holds(x * y, a * b, b * 0.7));
      CHECK(holds(x / y, a / b, b / 0.7));
      CHECK(holds(-x, -a, -b));
      CHECK(holds(x.swapped(), b, a));
      CHECK(holds(x.mirrored(), -a, b));
      CHECK(holds(x.sum(), a + b, b + a));
      CHECK(holds(x.abs(), std::abs(a), std::abs(b)));
      CHECK(holds(x.withSign(y), std::copysign(a, b), std::copysign(b, 0.7)));
      CHECK(holds(x.atLeast(y), std::max(a, b), std::max(b, 0.7)));
      CHECK(holds(x.clamped(-y.abs(), y.abs()), clamped(a, std::abs(b)), clamped(b, 0.7)));
      CHECK(holds(WheelPair(3.0).whereBelow(x, y), a < b ? 3.0 : 0.0, b < 0.7 ? 3.0 : 0.0));
      CHECK(holds(WheelPair(3.0).whereEqual(x, y), a == b ? 3.0 : 0.0, b == 0.7 ? 3.0 : 0.0));
      CHECK(holds(WheelPair(3.0).whereAny(x), a != 0.0 ? 3.0 : 0.0, b != 0.0 ? 3.0 : 0.0));
    }
  }
}

TEST_CASE("what is no number stays none in a pair", "[unit]") {
  const double none = std::nan("");
  const WheelPair x(none, 2.0);
  CHECK(holds(x.clamped(WheelPair(-1.0), WheelPair(1.0)), none, 1.0));
  CHECK(holds(x.atLeast(WheelPair(0.0)), none, 2.0));
  CHECK(holds(WheelPair(3.0).whereBelow(x, WheelPair(5.0)), 0.0, 3.0));
  CHECK(holds(WheelPair(3.0).whereAny(x), 3.0, 3.0));
}

}  // namespace fulbito
