#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/interval.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

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

TEST_CASE("Student's interval of a mean has the textbook's values", "[unit]") {
  const std::vector<double> values = {1.0, 2.0, 3.0, 4.0, 5.0};  // deviation sqrt(2.5), t(4) = 2.7764
  const Interval interval = meanInterval(values);
  CHECK(interval.value == 3.0);
  CHECK(interval.high - 3.0 == Approx(2.7764 * std::sqrt(2.5 / 5)).margin(1e-4));
  CHECK(3.0 - interval.low == Approx(interval.high - 3.0));
  // From the tables: t(10) = 2.2281, t(30) = 2.0423, t(99) = 1.9842.
  for (const auto& [n, t] : {std::pair{11, 2.2281}, {31, 2.0423}, {100, 1.9842}}) {
    std::vector<double> alternating(static_cast<std::size_t>(n));
    double squares = 0.0;
    for (std::size_t i = 0; i < alternating.size(); ++i) alternating[i] = i % 2 == 0 ? 1.0 : -1.0;
    for (double v : alternating) squares += (v - mean(alternating)) * (v - mean(alternating));
    const Interval wide = meanInterval(alternating);
    CHECK(wide.high - wide.value == Approx(t * std::sqrt(squares / (n - 1) / n)).epsilon(2e-5));
  }
  CHECK(std::isnan(meanInterval(std::vector<double>{1.0}).low));
  CHECK(meanInterval(std::vector<double>{1.0}).value == 1.0);
}

TEST_CASE("an interval of shares is Wilson's for rates, narrower for steadier values", "[unit]") {
  const std::vector<double> won(20, 1.0);
  CHECK(shareInterval(won).low == Approx(wilson(20, 20).low));
  CHECK(shareInterval(won).high == 1.0);
  std::vector<double> rates(100, 0.0);
  for (std::size_t i = 0; i < 30; ++i) rates[i] = 1.0;
  CHECK(shareInterval(rates).low == Approx(wilson(30, 100).low).margin(5e-4));
  const std::vector<double> even(100, 0.5);
  const Interval narrow = shareInterval(even);
  CHECK(narrow.value == 0.5);
  CHECK(narrow.high - narrow.low < 0.03);
  CHECK(narrow.high > narrow.low);
  CHECK(shareInterval(std::vector<double>{0.5}).low == Approx(0.0546).margin(1e-3));  // wilson at n = 1
  CHECK(shareInterval({}).high == 1.0);
}

TEST_CASE("an interval of shares covers the truth about as often as it says", "[unit]") {
  // Pairs of matches: each half won, drawn or lost; the true share is 0.85 or 0.5.
  for (const double win : {0.35, 0.75}) {
    for (const int n : {10, 50, 200}) {
      const double draw = win == 0.35 ? 0.3 : 0.2, truth = win + draw / 2;
      Rng random(static_cast<std::uint64_t>(n), test::kTestStream);
      int covered = 0;
      for (int round = 0; round < 1000; ++round) {
        std::vector<double> pairs;
        for (int i = 0; i < n; ++i) {
          double points = 0.0;
          for (int leg = 0; leg < 2; ++leg) {
            const double u = random.uniform();
            points += u < win ? 0.5 : (u < win + draw ? 0.25 : 0.0);
          }
          pairs.push_back(points);
        }
        const Interval interval = shareInterval(pairs);
        covered += interval.low <= truth && truth <= interval.high ? 1 : 0;
      }
      CAPTURE(win, n, covered);
      CHECK(covered >= 930);
    }
  }
}

}  // namespace fulbito
