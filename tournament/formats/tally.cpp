#include "tournament/formats/tally.hpp"

namespace fulbito {
namespace {

/// Adds a match in which the line's entrant won this share of the points (1, 1/2 or 0).
void addMatch(Standing& line, double share, int goals_for, int goals_against) {
  ++line.matches;
  line.won += share == 1.0;
  line.drawn += share == 0.5;
  line.lost += share == 0.0;
  line.points += leaguePoints(share);
  line.goals_for += goals_for;
  line.goals_against += goals_against;
}

void addPair(const PairResult& pair, Standing& a, Standing& b) {
  for (std::size_t leg = 0; leg < pair.legs.size(); ++leg) {
    const auto& score = pair.legs[leg].score;
    addMatch(a, pair.pointsOfLeg(leg), score[leg], score[1 - leg]);
    addMatch(b, 1.0 - pair.pointsOfLeg(leg), score[1 - leg], score[leg]);
  }
  a.pair_points += pair.points();
  b.pair_points += 1.0 - pair.points();
}

}  // namespace

std::vector<Standing> tally(const CountedResults& counted) {
  std::vector<Standing> lines(counted.plan.entrants.size());
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].entrant = i;
  forEachResult(counted, [&](const Fixture& fixture, const PairResult& pair) {
    addPair(pair, lines[fixture.a], lines[fixture.b]);
  });
  return lines;
}

Criterion fewerForfeits(const CountedResults& counted) {
  Criterion fewer{"fewer walk-overs", std::vector<double>(counted.plan.entrants.size())};
  forEachResult(counted, [&](const Fixture& fixture, const PairResult& pair) {
    for (std::size_t leg = 0; leg < pair.legs.size(); ++leg) {
      fewer.values[fixture.a] -= pair.legs[leg].faults.teams[leg].forfeited;
      fewer.values[fixture.b] -= pair.legs[leg].faults.teams[1 - leg].forfeited;
    }
  });
  return fewer;
}

}  // namespace fulbito
