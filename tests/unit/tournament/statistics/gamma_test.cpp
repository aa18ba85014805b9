#include "tournament/statistics/gamma.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace fulbito;

TEST_CASE("gamma draws have mean and variance of their shape", "[unit]") {
  constexpr int kDraws = 200'000;
  for (const double shape : {0.5, 1.0, 2.0, 7.0, 1000.0}) {
    Rng rng(1, Stream::kRatings);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kDraws; ++i) {
      const double x = gammaDraw(rng, shape);
      sum += x;
      squares += (x - shape) * (x - shape);
    }
    // Margins of five standard deviations. The fourth central moment is 3 shape^2 + 6 shape.
    const double variance_spread = std::sqrt(2 * shape * shape + 6 * shape);
    CHECK(sum / kDraws == Approx(shape).margin(5 * std::sqrt(shape / kDraws)));
    CHECK(squares / kDraws == Approx(shape).margin(5 * variance_spread / std::sqrt(kDraws)));
  }
}

TEST_CASE("gamma draws of shape 1/2 are half of squared normal draws", "[unit]") {
  constexpr int kDraws = 100'000;
  Rng rng(2, Stream::kRatings);
  int below = 0;
  // Half the square of a standard normal x has this distribution, so the condition means |x| < 1.
  for (int i = 0; i < kDraws; ++i) below += gammaDraw(rng, 0.5) < 0.5 ? 1 : 0;
  CHECK(below / double{kDraws} == Approx(0.6826895).margin(0.0075));
}
