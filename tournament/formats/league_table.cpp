#include <algorithm>
#include <array>

#include "tournament/formats/fixed_formats.hpp"
#include "tournament/formats/tables.hpp"

namespace fulbito {
namespace {

constexpr std::string_view kPoints = "points";

int differenceOf(const Standing& line) { return line.goals_for - line.goals_against; }

/// Points and goal difference of each entrant against each other.
class HeadToHead {
 public:
  explicit HeadToHead(const CountedResults& counted)
      : size_(counted.plan.entrants.size()), points_(size_ * size_), difference_(size_ * size_) {
    for (std::size_t i = 0; i < counted.results.size(); ++i) {
      if (counted.results[i]) add(*counted.results[i], counted.fixtures[i]);
    }
  }

  /// Both criteria, of the matches between the entrants of a block.
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

std::vector<Standing> leagueTable(const CountedResults& counted) {
  const std::vector<Standing> lines = tally(counted);
  const std::array criteria{
      criterion(kPoints, lines, [](const Standing& line) { return line.points; }),
      criterion("goal difference", lines, differenceOf),
      criterion("goals scored", lines, [](const Standing& line) { return line.goals_for; })};
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

std::vector<Standing> gauntletTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  // Quotients of whole numbers are rounded correctly: equal ratios are equal numbers.
  const auto per_match = [&](std::string_view name, auto value) {
    return criterion(name, table, [&](const Standing& line) {
      return static_cast<double>(value(line)) / std::max(1, line.matches);
    });
  };
  const std::array criteria{
      per_match(kPoints, [](const Standing& line) { return line.points; }),
      per_match("goal difference per match", differenceOf),
      per_match("goals scored per match", [](const Standing& line) { return line.goals_for; }),
      fewerForfeits(counted)};
  sortBy(table, criteria);
  giveRanks(table, kPoints);
  return table;
}

}  // namespace fulbito
