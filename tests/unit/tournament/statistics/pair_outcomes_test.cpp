#include "tournament/statistics/pair_outcomes.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;

TEST_CASE("pairs count by the results of their matches, in either order", "[unit]") {
  PairOutcomes pairs;
  for (const double first : {0.0, 0.5, 1.0}) {
    for (const double second : {0.0, 0.5, 1.0}) pairs.add(first, second);
  }
  CHECK(pairs.counts == std::array<std::int64_t, 6>{1, 2, 1, 2, 2, 1});
  CHECK(pairs.pairs() == 9);
  CHECK(pairs.wins() == 6);
  CHECK(pairs.draws() == 6);
  CHECK(pairs.losses() == 6);
}

TEST_CASE("two draws and a win with a loss have the same score", "[unit]") {
  PairOutcomes pairs;
  pairs.counts = {1, 2, 4, 8, 16, 32};
  CHECK(pairs.scores().counts == std::array<std::int64_t, 5>{1, 2, 12, 16, 32});
  CHECK(pairs.wins() == 8 + 16 + 64);
  CHECK(pairs.draws() == 2 + 8 + 16);
  CHECK(pairs.losses() == 2 + 2 + 8);
}
