#pragma once

#include <vector>

#include "tournament/formats/circle.hpp"
#include "tournament/formats/perfect_matching.hpp"

namespace fulbito {

/// Pairings for all remaining rounds of a long Swiss tournament; no pair is in two of them. They begin as
/// rounds of the circle method. They guarantee that no tournament runs out of possible pairings: the next
/// round is one of them, or another one after which enough pairings are left.
///
/// Two pairings together form cycles through all places. Exchanging one such cycle between them gives two
/// pairings again. So the next round can be adapted to the points without losing a later round.
class ReservedRounds {
 public:
  /// @param places  an even number
  /// @param rounds  fewer than places
  ReservedRounds(std::size_t places, std::size_t rounds);

  bool empty() const { return rounds_.empty(); }

  /// Looks for reserved rounds, one fewer than at present, among the meetings possible after the next round.
  /// Returns whether it found them; otherwise nothing changes. Large tournaments skip the search.
  bool renew(const OpenMeetings& after_next);

  /// Removes and returns a round, adapted so that opponents have similar points: a local minimum of the sum
  /// of squared differences. `points` by place; an absent last place counts as having the lowest points.
  Pairing take(std::vector<double> points);

 private:
  using Mates = std::vector<std::size_t>;  // opponent by place

  std::vector<Mates> rounds_;
};

}  // namespace fulbito
