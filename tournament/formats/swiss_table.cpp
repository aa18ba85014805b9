#include <algorithm>
#include <array>

#include "tournament/formats/tables.hpp"

namespace fulbito {
namespace {

constexpr std::string_view kPairPoints = "points of pairs";

/// Gives a bye to who has no fixture in a round that has begun to count. Rounds are known to the last
/// fixture.
void addByes(const CountedResults& counted, std::vector<Standing>& lines) {
  const auto& fixtures = counted.fixtures;
  std::size_t next = 0;
  while (next < counted.results.size()) {
    std::vector<bool> plays(lines.size());
    const int round = fixtures[next].round;
    for (; next < fixtures.size() && fixtures[next].round == round; ++next) {
      plays[fixtures[next].a] = plays[fixtures[next].b] = true;
    }
    for (Standing& line : lines) {
      if (plays[line.entrant]) continue;
      ++line.byes;
      line.pair_points += counted.plan.pairs;
    }
  }
}

/// Buchholz and Sonneborn-Berger. Sums over pairs are `pairs` times those over meetings.
std::array<Criterion, 2> opponentsOf(const CountedResults& counted, const std::vector<Standing>& lines) {
  std::array<Criterion, 2> sums{Criterion{"Buchholz", std::vector<double>(lines.size())},
                                Criterion{"Sonneborn-Berger", std::vector<double>(lines.size())}};
  for (const Standing& line : lines) {
    const double byes = line.byes * line.pair_points * counted.plan.pairs;
    sums[0].values[line.entrant] += byes;
    sums[1].values[line.entrant] += byes;
  }
  for (std::size_t i = 0; i < counted.results.size(); ++i) {
    if (!counted.results[i]) continue;
    const auto& [a, b, round, start] = counted.fixtures[i];
    const double share = counted.results[i]->points();
    sums[0].values[a] += lines[b].pair_points;
    sums[0].values[b] += lines[a].pair_points;
    sums[1].values[a] += lines[b].pair_points * share;
    sums[1].values[b] += lines[a].pair_points * (1.0 - share);
  }
  return sums;
}

}  // namespace

std::vector<Standing> swissTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  addByes(counted, table);
  const auto opponents = opponentsOf(counted, table);
  const std::array criteria{
      criterion(kPairPoints, table, [](const Standing& line) { return line.pair_points; }), opponents[0],
      opponents[1],
      criterion("goal difference", table,
                [](const Standing& line) { return line.goals_for - line.goals_against; }),
      criterion("goals scored", table, [](const Standing& line) { return line.goals_for; })};
  sortBy(table, criteria);
  giveRanks(table, kPairPoints);
  return table;
}

}  // namespace fulbito
