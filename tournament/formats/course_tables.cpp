#include <array>

#include "tournament/formats/knock_out.hpp"
#include "tournament/formats/ladder.hpp"
#include "tournament/formats/tables.hpp"

namespace fulbito {
namespace {

/// How far each entrant came in a knock-out.
struct Progress {
  explicit Progress(std::size_t entrants)
      : rounds{"round reached", std::vector<double>(entrants)},
        still_in{"still in", std::vector<double>(entrants, 1.0)},
        third{"match for the third place", std::vector<double>(entrants)} {}

  void add(const KnockOutTie& tie) {
    if (!tie.winner) return;
    const auto& loser = tie.winner == tie.a ? tie.b : tie.a;
    if (tie.third_place) {
      third.values[*tie.winner] = 1.0;
      return;
    }
    rounds.values[*tie.winner] += 1.0;
    if (loser) still_in.values[*loser] = 0.0;
  }

  Criterion rounds, still_in, third;
};

}  // namespace

std::vector<Standing> knockOutTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  Progress progress(table.size());
  for (const KnockOutTie& tie : knockOutCourse(counted.plan, counted.results).ties) {
    progress.add(tie);
    if (tie.decided_by == "bye") ++table[*tie.winner].byes;
  }
  sortBy(table, std::array{progress.rounds, progress.still_in, progress.third});
  giveRanks(table, "");
  return table;
}

std::vector<Standing> ladderTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  Criterion place{"place", std::vector<double>(table.size())};
  double height = static_cast<double>(table.size());
  for (const std::size_t entrant : ladderCourse(counted.plan, counted.results).order) {
    place.values[entrant] = height;
    height -= 1.0;
  }
  sortBy(table, std::span(&place, 1));
  giveRanks(table, "");
  return table;
}

}  // namespace fulbito
