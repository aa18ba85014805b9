#include "replays/coding/columns.hpp"

#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("whole steps are the nearest, and nothing impossible is cast", "[unit]") {
  CHECK(wholeSteps(0.0149, 0.01) == 1);
  CHECK(wholeSteps(0.0151, 0.01) == 2);
  CHECK(wholeSteps(-0.0151, 0.01) == -2);
  CHECK(wholeSteps(46.08, 0.01) == 4608);
  CHECK(wholeSteps(1e30, 0.01) == 0);
  CHECK(wholeSteps(std::numeric_limits<double>::quiet_NaN(), 0.01) == 0);
  CHECK(wholeSteps(-std::numeric_limits<double>::infinity(), 0.01) == 0);
  // What was rounded to the step comes back to the same bits.
  for (int i = -5000; i <= 5000; ++i) {
    const double rounded = static_cast<double>(i) * 0.01;
    REQUIRE(wholeSteps(rounded, 0.01) * 0.01 == rounded);
  }
}

}  // namespace fulbito
