#include "tournament/statistics/elo.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tournament/statistics/normal.hpp"

using namespace fulbito;

TEST_CASE("Elo and score are each other's inverse", "[unit]") {
  CHECK(eloOf(0.5) == Approx(0.0).margin(1e-12));
  CHECK(eloOf(0.75) == Approx(190.848501888));  // 400 log10(3)
  CHECK(eloOf(10.0 / 11.0) == Approx(400.0));
  for (const double elo : {-300.0, -20.0, 1.0, 55.0}) CHECK(eloOf(scoreOf(elo)) == Approx(elo));
  CHECK(std::isinf(eloOf(0.0)));
  CHECK(std::isinf(eloOf(1.0)));
}

TEST_CASE("without draws and with equal teams a point of normalized Elo is a point of Elo", "[unit]") {
  // Scores of pairs of independent matches without draws have a binomial distribution.
  const double p = 0.502;
  const PairDistribution pairs{(1 - p) * (1 - p), 0.0, 2 * p * (1 - p), 0.0, p * p};
  CHECK(kEloPerStrength * normalizedStrength(momentsOf(pairs)) == Approx(eloOf(p)).epsilon(1e-4));
}

TEST_CASE("normalized strength does not depend on the share of drawn pairs' spread, Elo does", "[unit]") {
  // `drawish` has more drawn pairs and nearly no difference in strength.
  const PairMoments open = momentsOf({0.2, 0.0, 0.55, 0.0, 0.25});
  const PairMoments drawish = momentsOf({0.05, 0.0, 0.9, 0.0, 0.05 + 1e-12});
  CHECK(open.mean > drawish.mean);
  CHECK(normalizedStrength(open) == Approx((open.mean - 0.5) / std::sqrt(2 * open.variance)));
}

TEST_CASE("the estimate's interval covers the true strength in 95 of 100 series", "[unit]") {
  const double pairs = 400;
  PairCounts counts;
  counts.counts = {40, 88, 144, 88, 40};
  const EloEstimate even = estimateElo(counts);
  CHECK(even.elo.value == Approx(0.0).margin(1e-9));
  CHECK(even.superiority == Approx(0.5).margin(1e-6));
  const PairMoments moments = momentsOf(distributionOf(counts, 0.0));
  const double half = 1.959964 * std::sqrt(moments.variance / pairs);
  CHECK(even.elo.high == Approx(eloOf(0.5 + half)));
  CHECK(even.elo.low == Approx(-even.elo.high));
  CHECK(even.normalized_elo.high == Approx(kEloPerStrength * 1.959964 / std::sqrt(2 * pairs)));
}

TEST_CASE("no pair, only draws and only wins have an estimate without a number that is none", "[unit]") {
  const EloEstimate nothing = estimateElo({});
  CHECK(std::isinf(nothing.elo.high));
  CHECK(nothing.superiority == 0.5);
  PairCounts draws;
  draws.counts = {0, 0, 10, 0, 0};
  CHECK(estimateElo(draws).elo.value == 0.0);
  CHECK(estimateElo(draws).superiority == 0.5);
  PairCounts wins;
  wins.counts = {0, 0, 0, 0, 10};
  CHECK(std::isinf(estimateElo(wins).elo.value));
  CHECK(estimateElo(wins).superiority == 1.0);
}

TEST_CASE("the normal distribution has its tabulated values", "[unit]") {
  CHECK(normalShareBelow(0.0) == Approx(0.5).margin(1e-7));
  CHECK(normalShareBelow(1.0) == Approx(0.8413447461).margin(1e-7));
  CHECK(normalShareBelow(-1.959963985) == Approx(0.025).margin(1e-7));
  CHECK(normalShareBelow(3.0) == Approx(0.9986501020).margin(1e-7));
}
