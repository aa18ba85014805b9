#include "navigation/obstacles/range_smoother.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

RangeReading heard(double range) { return {{{0.04, 0.0}, 0.0}, 0.2, 0.4, true, range}; }
RangeReading silence() { return {{{0.04, 0.0}, 0.0}, 0.2, 0.4, false, 0.4}; }

}  // namespace

TEST_CASE("the mean of a window errs by a third of one reading's noise", "[unit]") {
  Rng rng(3, Stream::kSonar);
  RangeSmoother smoother;
  double square = 0.0;
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto mean = smoother.add(heard(0.2 + rng.normal(0.0, 0.005)), {});
    if (i % 9 != 8 || !mean) continue;
    square += (mean->range - 0.2) * (mean->range - 0.2), ++count;
  }
  CHECK(count > 300);
  CHECK(std::sqrt(square / count) == Approx(0.005 / 3.0).epsilon(0.15));
}

TEST_CASE("a moving sensor's mean belongs to the middle of its way", "[unit]") {
  RangeSmoother smoother;
  std::optional<SmoothRange> mean;
  for (int i = 0; i < 9; ++i) mean = smoother.add(heard(0.3 - 0.004 * i), {{0.004 * i, 0.0}, 0.0});
  REQUIRE(mean);
  CHECK(mean->apex.x == Approx(0.04 + 0.016));
  CHECK(mean->apex.x + mean->range == Approx(0.34));
}

TEST_CASE("a jump from one surface to another gives no answer", "[unit]") {
  RangeSmoother smoother;
  for (int i = 0; i < 5; ++i) smoother.add(heard(0.15), {});
  for (int i = 0; i < 3; ++i) smoother.add(heard(0.25), {});
  CHECK_FALSE(smoother.add(heard(0.25), {}));
}

TEST_CASE("drop-outs do not make a silence, and single echoes no surface", "[unit]") {
  RangeSmoother loud, silent;
  std::optional<SmoothRange> of_loud, of_silent;
  for (int i = 0; i < 9; ++i) {
    of_loud = loud.add(i % 4 == 1 ? silence() : heard(0.2), {});
    of_silent = silent.add(i == 4 ? heard(0.2) : silence(), {});
  }
  REQUIRE(of_loud);
  CHECK(of_loud->heard);
  CHECK(of_loud->range == Approx(0.2));
  REQUIRE(of_silent);
  CHECK_FALSE(of_silent->heard);
  CHECK(of_silent->range == Approx(0.4));
}
