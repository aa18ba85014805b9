#pragma once

#include <vector>

#include "tournament/formats/circle.hpp"
#include "tournament/formats/perfect_matching.hpp"

namespace fulbito {

/// Pairings for all rounds to come of a long Swiss tournament, without a common pair. They begin as rounds of
/// the circle method. As long as they exist, no tournament ends early: the next round is one of them, or
/// another for which as many rounds after it have been found.
///
/// Two pairings together are cycles through all places. Exchanging one such cycle between them gives two
/// pairings again: so the next round is adapted to the points without losing a later one.
class ReservedRounds {
 public:
  /// @param places  an even number
  /// @param rounds  fewer than places
  ReservedRounds(std::size_t places, std::size_t rounds);

  bool empty() const { return rounds_.empty(); }

  /// Looks for one round less than now among the meetings that are possible after the next round. Returns
  /// whether it found them; otherwise nothing changes. In large tournaments it does not try.
  bool renew(const OpenMeetings& after_next);

  /// Takes out a round in which opponents have as equal points as exchanges of cycles reach: a local least
  /// sum of squared differences. `points` by place; an absent last place counts as the least of them.
  Pairing take(std::vector<double> points);

 private:
  using Mates = std::vector<std::size_t>;  // opponent by place

  std::vector<Mates> rounds_;
};

}  // namespace fulbito
