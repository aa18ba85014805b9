#include <algorithm>
#include <array>

#include "tournament/formats/format.hpp"
#include "tournament/formats/meeting.hpp"
#include "tournament/formats/swiss_pairing.hpp"

namespace fulbito {
namespace {

class Swiss {
 public:
  explicit Swiss(const TournamentPlan& plan)
      : plan_(plan),
        pairing_(plan.entrants.size(), static_cast<std::size_t>(roundsOf(plan))),
        points_(plan.entrants.size()) {}

  /// Schedules the next round. Returns whether all its results exist.
  bool playRound(int round, ResultsView results) {
    bool all = true;
    for (const auto& [a, b] : pairing_.next(points_)) {
      if (b == plan_.entrants.size()) {
        points_[a] += plan_.pairs;
      } else {
        all = meet({a, b, round, 0}, results) && all;
      }
    }
    return all;
  }

  Schedule take(bool complete) {
    schedule_.complete = complete;
    return std::move(schedule_);
  }

 private:
  bool meet(const Fixture& first, ResultsView results) {
    MeetingScore score;
    const bool all = addResults(results, addMeeting(schedule_.fixtures, first, plan_.pairs), score);
    points_[first.a] += score.points[0] / 2;
    points_[first.b] += score.points[1] / 2;
    return all;
  }

  const TournamentPlan& plan_;
  SwissPairing pairing_;
  std::vector<double> points_;  // points of pairs, by entrant
  Schedule schedule_;
};

/// Each round pairs entrants who have not met and have points of pairs as equal as possible (`SwissPairing`).
/// With an odd number of entrants, one has a bye per round, nobody twice. A bye counts as a meeting with all
/// pairs won.
Schedule swissSchedule(const TournamentPlan& plan, ResultsView results) {
  Swiss swiss(plan);
  for (int round = 0; round < roundsOf(plan); ++round) {
    if (!swiss.playRound(round, results)) return swiss.take(false);
  }
  return swiss.take(true);
}

/// The smallest k with 2^k >= entrants: after k rounds at most one entrant has won all its meetings.
int roundsToOne(std::size_t entrants) {
  int rounds = 0;
  while ((std::size_t{1} << rounds) < entrants) ++rounds;
  return rounds;
}

constexpr std::string_view kPairPoints = "points of pairs";

/// Gives a bye to each entrant without a fixture in a round that has begun to count. Requires that rounds are
/// scheduled as a whole.
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

/// Criteria Buchholz and Sonneborn-Berger. Both sum over pairs, so values are `pairs` times those over
/// meetings.
std::array<Criterion, 2> opponentsOf(const CountedResults& counted, const std::vector<Standing>& lines) {
  std::array<Criterion, 2> sums{Criterion{"Buchholz", std::vector<double>(lines.size())},
                                Criterion{"Sonneborn-Berger", std::vector<double>(lines.size())}};
  for (const Standing& line : lines) {
    const double byes = line.byes * line.pair_points * counted.plan.pairs;
    sums[0].values[line.entrant] += byes;
    sums[1].values[line.entrant] += byes;
  }
  forEachResult(counted, [&](const Fixture& fixture, const PairResult& pair) {
    const std::size_t a = fixture.a, b = fixture.b;
    const double share = pair.points();
    sums[0].values[a] += lines[b].pair_points;
    sums[0].values[b] += lines[a].pair_points;
    sums[1].values[a] += lines[b].pair_points * share;
    sums[1].values[b] += lines[a].pair_points * (1.0 - share);
  });
  return sums;
}

/// Criteria: points of pairs; Buchholz (sum of the opponents' points of pairs); Sonneborn-Berger (that sum
/// with each term times the points won against the opponent); goal difference; goals scored. A bye counts as
/// an opponent with the same points as the entrant, against whom it won all pairs.
std::vector<Standing> swissTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  addByes(counted, table);
  const auto opponents = opponentsOf(counted, table);
  const std::array criteria{
      criterion(kPairPoints, table, [](const Standing& line) { return line.pair_points; }), opponents[0],
      opponents[1], criterion("goal difference", table, goalDifferenceOf),
      criterion("goals scored", table, goalsForOf)};
  return ranked(std::move(table), criteria, kPairPoints);
}

}  // namespace

extern const Format kSwissFormat{.schedule = swissSchedule,
                                 .table = swissTable,
                                 .most_fixtures = mostOfRounds,
                                 .rounds = roundsToOne,
                                 .meets_once = true,
                                 .counts_pair_points = true};

}  // namespace fulbito
