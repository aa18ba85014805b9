#include "engine/core/statistics.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("Wilson's interval has its published values", "[unit]") {
  // Newcombe (1998), Table I, method 3: 81/263, 15/148, 0/20, 1/29.
  CHECK(wilson(81, 263).low == Approx(0.2553).margin(5e-5));
  CHECK(wilson(81, 263).high == Approx(0.3662).margin(5e-5));
  CHECK(wilson(15, 148).low == Approx(0.0624).margin(5e-5));
  CHECK(wilson(15, 148).high == Approx(0.1605).margin(5e-5));
  CHECK(wilson(0, 20).low == Approx(0.0).margin(1e-12));
  CHECK(wilson(0, 20).high == Approx(0.1611).margin(5e-5));
  CHECK(wilson(1, 29).high == Approx(0.1718).margin(5e-5));
  CHECK(wilson(0, 0).high == 1.0);
}

TEST_CASE("quantiles interpolate between order statistics", "[unit]") {
  std::vector<double> values = {4.0, 1.0, 3.0, 2.0};
  CHECK(quantile(values, 0.0) == 1.0);
  CHECK(quantile(values, 0.5) == Approx(2.5));
  CHECK(quantile(values, 1.0) == 4.0);
  std::vector<double> none;
  CHECK(std::isnan(quantile(none, 0.5)));
}

TEST_CASE("a paired difference covers its value and shrinks to a point where all pairs agree", "[unit]") {
  const std::vector<double> a = {0.9, 1.8, 2.7}, b = {1.0, 2.0, 3.0};
  const Interval same = pairedRelativeDifference(a, b, 1);
  CHECK(same.value == Approx(-0.1));
  CHECK(same.low == Approx(-0.1));
  CHECK(same.high == Approx(-0.1));
  const std::vector<double> c = {1.1, 1.7, 3.0};
  const Interval spread = pairedRelativeDifference(c, b, 1);
  CHECK(spread.low < spread.value);
  CHECK(spread.high > spread.value);
  CHECK(std::isnan(pairedRelativeDifference({}, {}, 1).value));
}

}  // namespace fulbito
