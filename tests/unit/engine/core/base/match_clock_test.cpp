#include "engine/core/base/match_clock.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("a clock is cut to tenths, never rounded up", "[unit]") {
  CHECK(clockText(0.0) == "0:00.0");
  CHECK(clockText(14.05) == "0:14.0");
  CHECK(clockText(14.0999) == "0:14.0");
  CHECK(clockText(59.99) == "0:59.9");
  CHECK(clockText(417.95) == "6:57.9");
  CHECK(clockText(163.05) == "2:43.0");
  CHECK(clockText(3600.0) == "60:00.0");
}

TEST_CASE("a tenth that a sum of ticks just misses is that tenth", "[unit]") {
  for (int ticks = 0; ticks < 6000; ticks += 6) {
    INFO(ticks);
    CHECK(clockText(ticks / 60.0).ends_with(std::to_string(ticks / 6 % 10)));
  }
}

TEST_CASE("times that are none are the beginning", "[unit]") {
  CHECK(clockText(-3.0) == "0:00.0");
  CHECK(clockText(std::nan("")) == "0:00.0");
  CHECK(clockText(std::numeric_limits<double>::infinity()) == "1666666:40.0");
}

TEST_CASE("periods have names", "[unit]") {
  CHECK(periodName(1) == "1st half");
  CHECK(periodName(2) == "2nd half");
  CHECK(periodName(3) == "overtime");
  CHECK(periodName(4) == "shoot-out");
}

}  // namespace fulbito
