#include "tournament/statistics/win_graph.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

bool bounded(std::size_t entrants, const std::vector<WeightedMeeting>& meetings) {
  const WinGraph graph = winGraph(entrants, meetings);
  return std::find(graph.without_bound.begin(), graph.without_bound.end(), true) == graph.without_bound.end();
}

}  // namespace

TEST_CASE("entrants that met, directly or not, form components", "[unit]") {
  const std::vector<WeightedMeeting> meetings{{0, 3, 1, 0, 1}, {3, 4, 0, 1, 0}, {1, 5, 2, 0, 0}};
  const WinGraph graph = winGraph(6, meetings);
  CHECK(graph.component == std::vector<int>{0, 1, 2, 0, 0, 1});
  CHECK(graph.without_bound == std::vector<bool>{false, true, false});
  CHECK(winGraph(0, {}).component.empty());
}

TEST_CASE("ratings exist where nobody, and no group, won everything against the rest", "[unit]") {
  CHECK(bounded(2, {{0, 1, 1, 0, 1}}));
  CHECK_FALSE(bounded(2, {{0, 1, 5, 0, 0}}));
  CHECK_FALSE(bounded(2, {{0, 1, 0, 0, 5}}));
  CHECK(bounded(3, {{0, 1, 1, 0, 0}, {1, 2, 1, 0, 0}, {0, 2, 0, 0, 1}}));        // a circle
  CHECK_FALSE(bounded(3, {{0, 1, 1, 0, 0}, {1, 2, 1, 0, 0}, {0, 2, 1, 0, 0}}));  // an order
  // Two pairs of equal entrants; one pair won all matches against the other.
  CHECK_FALSE(bounded(4, {{0, 1, 1, 0, 1}, {2, 3, 1, 0, 1}, {0, 2, 3, 0, 0}, {1, 3, 3, 0, 0}}));
}

TEST_CASE("draws alone bound no ratings: leads and draws may grow together", "[unit]") {
  CHECK_FALSE(bounded(2, {{0, 1, 0, 3, 0}}));
  CHECK_FALSE(bounded(2, {{0, 1, 2, 3, 0}}));
  CHECK(bounded(2, {{0, 1, 2, 3, 1}}));
  // A beat B; A and C drew, B and C drew. A closed walk with the win has one more draw than wins.
  CHECK_FALSE(bounded(3, {{0, 1, 1, 0, 0}, {0, 2, 0, 1, 0}, {1, 2, 0, 1, 0}}));
  // A closed walk with two wins and one draw.
  CHECK(bounded(3, {{0, 1, 1, 0, 0}, {1, 2, 1, 0, 0}, {0, 2, 0, 1, 0}}));
  // The draw parameter is determined by two other entrants.
  CHECK(bounded(4, {{0, 1, 2, 3, 0}, {2, 3, 1, 0, 1}}));
}
