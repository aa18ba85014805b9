#include <algorithm>
#include <array>

#include "tournament/formats/circle.hpp"
#include "tournament/formats/format.hpp"

namespace fulbito {
namespace {

/// Rounds in which each of `entrants` meets each other once. If their number is odd, one rests per round.
std::size_t roundsPerCycle(std::size_t entrants) { return entrants + entrants % 2 - 1; }

/// All fixtures of one start. Rounds count from 0.
std::vector<Fixture> cycleOf(const std::vector<std::vector<std::size_t>>& groups, std::size_t rounds) {
  std::vector<Fixture> cycle;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const auto& group : groups) {
      if (round >= roundsPerCycle(group.size())) continue;
      for (const auto& [a, b] : circleRound(group.size() + group.size() % 2, round)) {
        if (b < group.size()) cycle.push_back({group[a], group[b], static_cast<int>(round), 0});
      }
    }
  }
  return cycle;
}

/// Each entrant against each other of its group: all with the first start, then all with the second, and so
/// on. All groups play their rounds at the same time.
Schedule roundRobinSchedule(const TournamentPlan& plan, ResultsView /*results*/) {
  const auto groups = groupsOf(plan);
  std::size_t rounds = 0;
  for (const auto& group : groups) rounds = std::max(rounds, roundsPerCycle(group.size()));
  const std::vector<Fixture> cycle = cycleOf(groups, rounds);
  Schedule schedule;
  schedule.complete = true;
  schedule.fixtures.reserve(cycle.size() * static_cast<std::size_t>(plan.pairs));
  for (int start = 0; start < plan.pairs; ++start) {
    for (Fixture fixture : cycle) {
      fixture.start = static_cast<std::size_t>(start);
      fixture.round += start * static_cast<int>(rounds);
      schedule.fixtures.push_back(fixture);
    }
  }
  return schedule;
}

std::int64_t mostMeetings(const TournamentPlan& plan) {
  std::int64_t meetings = 0;
  for (const auto& group : groupsOf(plan)) {
    const auto size = static_cast<std::int64_t>(group.size());
    meetings += size * (size - 1) / 2;
  }
  return meetings * plan.pairs;
}

constexpr std::string_view kPoints = "points";

/// Points and goal difference of each entrant against each other.
class HeadToHead {
 public:
  explicit HeadToHead(const CountedResults& counted)
      : size_(counted.plan.entrants.size()), points_(size_ * size_), difference_(size_ * size_) {
    forEachResult(counted, [this](const Fixture& fixture, const PairResult& pair) { add(pair, fixture); });
  }

  /// Points and goal difference in the matches between the entrants of a block, as criteria.
  std::array<Criterion, 2> within(std::span<const Standing> block) const {
    std::array<Criterion, 2> criteria{
        Criterion{"points between those tied", std::vector<double>(size_)},
        Criterion{"goal difference between those tied", std::vector<double>(size_)}};
    for (const Standing& line : block) {
      for (const Standing& other : block) {
        criteria[0].values[line.entrant] += points_[line.entrant * size_ + other.entrant];
        criteria[1].values[line.entrant] += difference_[line.entrant * size_ + other.entrant];
      }
    }
    return criteria;
  }

 private:
  void add(const PairResult& pair, const Fixture& fixture) {
    const std::size_t ab = fixture.a * size_ + fixture.b, ba = fixture.b * size_ + fixture.a;
    for (std::size_t leg = 0; leg < pair.legs.size(); ++leg) {
      const double share = pair.pointsOfLeg(leg);
      points_[ab] += leaguePoints(share);
      points_[ba] += leaguePoints(1.0 - share);
    }
    difference_[ab] += pair.goalsOfA() - pair.goalsOfB();
    difference_[ba] += pair.goalsOfB() - pair.goalsOfA();
  }

  std::size_t size_;
  std::vector<int> points_, difference_;  // [row * size_ + opponent]
};

void separate(std::span<Standing> tied, const HeadToHead& meetings, const Criterion& last) {
  for (const auto block : sortBy(tied, meetings.within(tied))) {
    if (block.size() < tied.size()) {
      separate(block, meetings, last);
    } else {
      sortBy(block, std::span(&last, 1));
    }
  }
}

}  // namespace

std::vector<std::vector<std::size_t>> groupsOf(const TournamentPlan& plan) {
  const auto count = static_cast<std::size_t>(plan.groups);
  std::vector<std::vector<std::size_t>> groups(count);
  for (std::size_t i = 0; i < plan.entrants.size(); ++i) {
    const std::size_t place = i % count;
    groups[i / count % 2 == 0 ? place : count - 1 - place].push_back(i);
  }
  return groups;
}

std::vector<Standing> leagueTable(const CountedResults& counted) {
  const std::vector<Standing> lines = tally(counted);
  const std::array criteria{criterion(kPoints, lines, [](const Standing& line) { return line.points; }),
                            criterion("goal difference", lines, goalDifferenceOf),
                            criterion("goals scored", lines, goalsForOf)};
  const HeadToHead meetings(counted);
  const Criterion forfeits = fewerForfeits(counted);
  std::vector<Standing> table;
  table.reserve(lines.size());
  for (const auto& group : groupsOf(counted.plan)) {
    const int number = table.empty() ? 0 : table.back().group + 1;
    for (const std::size_t entrant : group) table.push_back(lines[entrant]), table.back().group = number;
    const std::span part = std::span(table).last(group.size());
    for (const auto tied : sortBy(part, criteria)) separate(tied, meetings, forfeits);
    giveRanks(part, kPoints);
  }
  return table;
}

extern const Format kRoundRobinFormat{
    .schedule = roundRobinSchedule, .table = leagueTable, .most_fixtures = mostMeetings, .has_groups = true};

}  // namespace fulbito
