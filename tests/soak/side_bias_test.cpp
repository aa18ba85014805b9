#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Goals of blue less those of yellow, a match, of a team against itself.
std::vector<double> differences(const std::string& team, int matches) {
  MatchConfig config = shortMatch(team, team, 60.0);
  std::vector<double> values;
  for (int i = 0; i < matches; ++i) {
    config.seed = static_cast<std::uint64_t>(i) + 1;
    auto match = Match::create(config);
    REQUIRE(match);
    while (match->step()) {
    }
    values.push_back(match->referee().score[0] - match->referee().score[1]);
  }
  return values;
}

}  // namespace

TEST_CASE("neither side is better: equal teams score alike on both", "[soak]") {
  // Kick-offs, physics and referee see blue first; a lean would show in every comparison that is not paired.
  for (const std::string team : {"chaser", "classic", "libero"}) {
    const std::vector<double> values = differences(team, 60);
    const Interval interval = meanInterval(values);
    const double error = (interval.high - interval.low) / 2 / 2.0;  // about one standard error
    CAPTURE(team, interval.value, error);
    CHECK(std::abs(interval.value) <= 3.5 * std::max(error, 0.02));
    CHECK(std::count(values.begin(), values.end(), 0.0) < 60);
  }
}

}  // namespace fulbito
