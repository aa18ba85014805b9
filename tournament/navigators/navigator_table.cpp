#include "tournament/navigators/navigator_table.hpp"

#include <algorithm>
#include <numeric>

#include "tournament/statistics/sign_test.hpp"

namespace fulbito {
namespace {

std::vector<UnitResult> resultsOf(const LayoutRuns& runs, double tie) {
  std::vector<UnitResult> results;
  for (std::size_t a = 0; a < runs.size(); ++a) {
    for (std::size_t b = a + 1; b < runs.size(); ++b) {
      for (std::size_t k = 0; k < runs[a].size(); ++k) {
        results.push_back({k, a, b, pointsOfRun(runs[a][k], runs[b][k], tie)});
      }
    }
  }
  return results;
}

/// Indices of the layouts on which all of `navigators` arrived.
std::vector<std::size_t> commonLayouts(const LayoutRuns& runs, std::span<const std::size_t> navigators) {
  std::vector<std::size_t> common;
  for (std::size_t k = 0; !runs.empty() && k < runs.front().size(); ++k) {
    if (std::all_of(navigators.begin(), navigators.end(),
                    [&](std::size_t n) { return runs[n][k].arrived; })) {
      common.push_back(k);
    }
  }
  return common;
}

/// Mean of a figure of one navigator over some layouts.
double meanOf(const std::vector<LayoutRun>& runs, std::span<const std::size_t> layouts,
              double LayoutRun::* figure) {
  std::vector<double> values;
  for (const std::size_t k : layouts) values.push_back(runs[k].*figure);
  return mean(values);
}

Interval meanDifference(const std::vector<LayoutRun>& first, const std::vector<LayoutRun>& second,
                        std::span<const std::size_t> layouts, double LayoutRun::* figure) {
  std::vector<double> differences;
  for (const std::size_t k : layouts) differences.push_back(first[k].*figure - second[k].*figure);
  return meanInterval(differences);
}

template <typename Counted>
void countResult(Counted& counted, double points) {
  ++(points > 0.75 ? counted.won : points < 0.25 ? counted.lost : counted.drawn);
}

NavigatorMeeting meetingOf(const LayoutRuns& runs, std::size_t first, std::size_t second, double tie) {
  NavigatorMeeting meeting;
  meeting.first = first;
  meeting.second = second;
  for (std::size_t k = 0; k < runs[first].size(); ++k) {
    countResult(meeting, pointsOfRun(runs[first][k], runs[second][k], tie));
  }
  meeting.p = signTest(meeting.won, meeting.lost);
  const std::vector<std::size_t> both = commonLayouts(runs, std::vector{first, second});
  meeting.both = static_cast<int>(both.size());
  meeting.time = meanDifference(runs[first], runs[second], both, &LayoutRun::time);
  meeting.length = meanDifference(runs[first], runs[second], both, &LayoutRun::length);
  return meeting;
}

NavigatorStanding standingOf(const LayoutRuns& runs, std::size_t navigator,
                             std::span<const std::size_t> common, double tie) {
  NavigatorStanding standing;
  standing.navigator = navigator;
  const std::vector<LayoutRun>& own = runs[navigator];
  const auto arrived =
      std::count_if(own.begin(), own.end(), [](const LayoutRun& run) { return run.arrived; });
  standing.arrived = wilson(static_cast<int>(arrived), static_cast<int>(own.size()));
  for (std::size_t other = 0; other < runs.size(); ++other) {
    if (other == navigator) continue;
    for (std::size_t k = 0; k < own.size(); ++k) {
      countResult(standing, pointsOfRun(own[k], runs[other][k], tie));
    }
  }
  standing.time = meanOf(own, common, &LayoutRun::time);
  standing.length = meanOf(own, common, &LayoutRun::length);
  return standing;
}

void fillMeetings(const LayoutRuns& runs, double tie, const Ratings& ratings, NavigatorTable& table) {
  for (std::size_t i = 0; i < table.standings.size(); ++i) {
    for (std::size_t j = i + 1; j < table.standings.size(); ++j) {
      const std::size_t first = table.standings[i].navigator, second = table.standings[j].navigator;
      table.meetings.push_back(meetingOf(runs, first, second, tie));
      table.meetings.back().superiority = ratings.superiority[first][second];
    }
  }
  std::vector<double> p;
  p.reserve(table.meetings.size());
  for (const NavigatorMeeting& meeting : table.meetings) p.push_back(meeting.p);
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < p.size(); ++i) table.meetings[i].p_holm = corrected[i];
}

}  // namespace

double pointsOfRun(const LayoutRun& first, const LayoutRun& second, double tie) {
  if (first.arrived != second.arrived) return first.arrived ? 1.0 : 0.0;
  if (!first.arrived) return 0.5;
  const double lead = second.time - first.time;
  return lead > tie ? 1.0 : lead < -tie ? 0.0 : 0.5;
}

NavigatorTable navigatorTable(const LayoutRuns& runs, double tie, std::uint64_t seed) {
  NavigatorTable table;
  const std::size_t layouts = runs.empty() ? 0 : runs.front().size();
  const Ratings ratings = rateUnits(runs.size(), layouts, resultsOf(runs, tie), seed);
  std::vector<std::size_t> all(runs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::size_t> common = commonLayouts(runs, all);
  for (const std::size_t n : all) {
    table.standings.push_back(standingOf(runs, n, common, tie));
    table.standings.back().elo = ratings.elo[n];
  }
  std::stable_sort(table.standings.begin(), table.standings.end(),
                   [](const auto& a, const auto& b) { return a.elo.value > b.elo.value; });
  fillMeetings(runs, tie, ratings, table);
  table.layouts = static_cast<int>(layouts);
  table.common = static_cast<int>(common.size());
  table.draw_share = ratings.draw_share;
  table.prior = ratings.prior;
  return table;
}

}  // namespace fulbito
