#include "replays/render/canvas/axis.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("an axis has round steps around its range", "[unit]") {
  const Axis axis = niceAxis(0.0, 1.87);
  CHECK(axis.low == 0.0);
  CHECK(axis.high == Approx(2.0));
  CHECK(axis.step == Approx(0.2));
  CHECK(axis.steps() == 10);
  CHECK(axis.text(0.4) == "0.4");
  CHECK(axis.text(1.234, 1) == "1.23");
}

TEST_CASE("an axis goes below zero for negative values", "[unit]") {
  const Axis axis = niceAxis(-13.0, 14.0);
  CHECK(axis.low == Approx(-15.0));
  CHECK(axis.high == Approx(15.0));
  CHECK(axis.step == Approx(5.0));
  CHECK(axis.text(-5.0) == "-5");
}

TEST_CASE("an axis has 4 to 11 steps whatever the range", "[unit]") {
  for (double high : {1e-300, 1e-9, 0.0137, 0.99, 1.0, 4.0, 4.01, 99.0, 12345.0, 1e9, 1e300}) {
    for (double share : {0.0, 0.5, 1.0}) {
      CAPTURE(high, share);
      const Axis axis = niceAxis(-share * high, high);
      CHECK(axis.steps() >= 1);
      CHECK(axis.steps() <= 11);
      CHECK(axis.high >= std::min(high, 1e9));
      CHECK(axis.low <= std::max(-share * high, -1e9));
    }
  }
}

TEST_CASE("an axis without a range is 0 to 1", "[unit]") {
  const Axis axis = niceAxis(0.0, 0.0);
  CHECK(axis.low == 0.0);
  CHECK(axis.high == 1.0);
  CHECK(axis.steps() == 5);
}

TEST_CASE("a value that rounds to zero has no sign, and a huge one is short", "[unit]") {
  CHECK(Axis{}.text(-0.001) == "0.0");
  CHECK(Axis{}.text(-0.06) == "-0.1");
  CHECK(Axis{}.text(1e300) == "1e+300");
}

}  // namespace fulbito
