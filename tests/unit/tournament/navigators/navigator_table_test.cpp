#include "tournament/navigators/navigator_table.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tournament/statistics/elo.hpp"
#include "tournament/statistics/sign_test.hpp"

using namespace fulbito;

namespace {

constexpr double kTie = 0.01;

/// `layouts` runs that all arrive: after `time` [s] on the first layout, 0.001 s later on each further one.
std::vector<LayoutRun> steady(std::size_t layouts, double time) {
  std::vector<LayoutRun> runs;
  for (std::size_t k = 0; k < layouts; ++k)
    runs.push_back({true, time + 0.001 * static_cast<double>(k), time});
  return runs;
}

}  // namespace

TEST_CASE("arriving beats failing, then the clear lead in time decides", "[unit]") {
  const LayoutRun slow{true, 3.0, 1.0}, fast{true, 2.0, 1.5}, failed{false, 0.5, 0.2};
  CHECK(pointsOfRun(fast, slow, kTie) == 1.0);
  CHECK(pointsOfRun(slow, fast, kTie) == 0.0);
  CHECK(pointsOfRun(slow, failed, kTie) == 1.0);
  CHECK(pointsOfRun(failed, slow, kTie) == 0.0);
  CHECK(pointsOfRun(failed, {false, 9.0, 9.0}, kTie) == 0.5);
  CHECK(pointsOfRun(fast, {true, 2.0099, 1.5}, kTie) == 0.5);
  CHECK(pointsOfRun(fast, {true, 2.0101, 1.5}, kTie) == 1.0);
}

TEST_CASE("the table counts wins, arrivals and means over common layouts", "[unit]") {
  // The first navigator is faster but fails on layouts 0 and 1. The third fails on all layouts but two.
  LayoutRuns runs{steady(20, 2.0), steady(20, 2.5), steady(20, 4.0)};
  runs[0][0].arrived = runs[0][1].arrived = false;
  for (std::size_t k = 0; k < 18; ++k) runs[2][k].arrived = false;
  const NavigatorTable table = navigatorTable(runs, kTie, 1);
  CHECK(table.layouts == 20);
  CHECK(table.common == 2);
  REQUIRE(table.standings.size() == 3);
  const NavigatorStanding& best = table.standings[0];
  CHECK(best.navigator == 0);
  CHECK(best.won == 18 + 18);
  CHECK(best.drawn == 2);
  CHECK(best.lost == 2);
  CHECK(best.arrived.value == Approx(0.9));
  CHECK(best.time == Approx(2.0185));  // over layouts 18 and 19
  CHECK(table.standings[2].navigator == 2);
  CHECK(table.standings[2].time == Approx(4.0185));
  CHECK(table.standings[2].length == Approx(4.0));
}

TEST_CASE("meetings have exact tests, Holm's correction and paired differences", "[unit]") {
  LayoutRuns runs{steady(20, 2.0), steady(20, 2.5), steady(20, 2.5)};
  for (std::size_t k = 0; k < 4; ++k) runs[0][k].arrived = false;
  for (std::size_t k = 0; k < 20; ++k) runs[2][k].length += k % 2 == 0 ? 0.1 : 0.3;
  const NavigatorTable table = navigatorTable(runs, kTie, 1);
  REQUIRE(table.meetings.size() == 3);
  const NavigatorMeeting& first = table.meetings[0];
  CHECK(first.won == 16);
  CHECK(first.lost == 4);
  CHECK(first.p == Approx(signTest(16, 4)));
  CHECK(first.p_holm == Approx(3 * first.p));
  CHECK(first.both == 16);
  CHECK(first.time.value == Approx(-0.5));
  CHECK(first.time.high - first.time.low == Approx(0.0).margin(1e-12));
  const NavigatorMeeting& equal = table.meetings[2];
  CHECK(equal.drawn == 20);
  CHECK(equal.p == 1.0);
  CHECK(equal.p_holm == 1.0);
  CHECK(equal.superiority == 0.5);
  // 20 values of -0.1 or -0.3: standard deviation 0.1026, t = 2.093.
  const double sign = equal.first == 1 ? -1.0 : 1.0;
  CHECK(equal.length.value == Approx(sign * 0.2));
  CHECK((equal.length.high - equal.length.low) / 2 ==
        Approx(2.0930 * 0.102598 / std::sqrt(20.0)).epsilon(1e-4));
}

TEST_CASE("two navigators are as far apart as their score tells", "[unit]") {
  LayoutRuns runs{steady(40, 2.0), steady(40, 2.5)};
  for (std::size_t k = 0; k < 10; ++k) runs[0][k].arrived = false;
  const NavigatorTable table = navigatorTable(runs, kTie, 1);
  CHECK(table.standings[0].elo.value - table.standings[1].elo.value == Approx(eloOf(0.75)));
  CHECK_FALSE(table.prior);
  CHECK(table.meetings[0].superiority > 0.99);
}

TEST_CASE("who wins on every layout has a rating with an interval", "[unit]") {
  const NavigatorTable table = navigatorTable({steady(10, 2.5), steady(10, 2.0)}, kTie, 1);
  CHECK(table.prior);
  CHECK(table.standings[0].navigator == 1);
  CHECK(std::isfinite(table.standings[0].elo.high));
  CHECK(table.standings[0].elo.high > table.standings[0].elo.low + 100.0);
  CHECK(table.meetings[0].p == Approx(2.0 / 1024));
}

TEST_CASE("layouts on which nobody arrives say nothing", "[unit]") {
  LayoutRuns runs{steady(3, 2.0), steady(3, 2.5)};
  for (auto& navigator : runs) {
    for (LayoutRun& run : navigator) run.arrived = false;
  }
  const NavigatorTable table = navigatorTable(runs, kTie, 1);
  CHECK(table.common == 0);
  CHECK(std::isnan(table.standings[0].time));
  CHECK(table.meetings[0].drawn == 3);
  CHECK(table.meetings[0].both == 0);
  CHECK(table.standings[0].elo.value == Approx(0.0).margin(1e-9));
}
