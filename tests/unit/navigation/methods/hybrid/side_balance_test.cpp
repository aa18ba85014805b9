#include "navigation/methods/hybrid/side_balance.hpp"

#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;

namespace {

std::vector<RangeReading> ranges(double left, double right) {
  std::vector<RangeReading> readings(8);
  readings[0] = {{}, 0.2, 0.36, true, left};
  readings[7] = {{}, 0.2, 0.36, true, right};
  return readings;
}

}  // namespace

TEST_CASE("half of the difference of both sides, smoothed against noise", "[unit]") {
  SideBalance balance;
  CHECK_FALSE(balance.inPassage());
  Rng rng(3, test::kTestStream);
  for (int i = 0; i < 60; ++i)
    balance.update(ranges(rng.normal(0.018, 0.005), rng.normal(0.008, 0.005)), 0.048);
  CHECK(balance.inPassage());
  CHECK(balance.offset() == Approx(0.005).margin(0.003));  // 3 sigma of the smoothed difference
}

TEST_CASE("with something near on one side only there is no passage", "[unit]") {
  SideBalance balance;
  balance.update(ranges(0.01, 0.2), 0.048);
  CHECK_FALSE(balance.inPassage());
  CHECK(balance.offset() == 0.0);
}

TEST_CASE("a passage is forgotten 0.2 s after its end", "[unit]") {
  SideBalance balance;
  balance.update(ranges(0.02, 0.01), 0.048);
  for (int i = 0; i < 11; ++i) balance.update({}, 0.048);
  CHECK(balance.offset() == Approx(0.005));
  balance.update({}, 0.048);
  CHECK(balance.offset() == 0.0);
}
