#pragma once

#include <vector>

#include "tournament/formats/schedule.hpp"
#include "tournament/formats/standings.hpp"

namespace fulbito {

/// A level tie has so many further pairs at most, one at a time.
inline constexpr int kMostExtraPairs = 3;

/// A knock-out so far.
struct KnockOutCourse {
  Schedule schedule;
  std::vector<KnockOutTie> ties;  ///< see `bracketOf`
};

/// Each tie has the plan's pairs. It is decided by points of matches, then goal difference, then further
/// pairs, then the better seeding. All ties of a round have the same number of pairs before further pairs are
/// scheduled.
KnockOutCourse knockOutCourse(const TournamentPlan& plan, ResultsView results);

/// The number of ties with two entrants: each but the last has one loser who leaves, and from four entrants
/// on there is a match for the third place.
constexpr std::int64_t knockOutTies(std::size_t entrants) {
  return static_cast<std::int64_t>(entrants) - (entrants >= 4 ? 0 : 1);
}

/// The order of `size` seeds, a power of two, in a bracket: the best two meet in the final at the earliest,
/// the best four in the semi-finals: 0 7 3 4 1 6 2 5.
std::vector<std::size_t> bracketOrder(std::size_t size);

}  // namespace fulbito
