#pragma once

#include <vector>

#include "tournament/formats/circle.hpp"
#include "tournament/formats/perfect_matching.hpp"
#include "tournament/formats/reserved_rounds.hpp"

namespace fulbito {

/// Pairs a Swiss tournament round by round; nobody meets twice. With an odd number of entrants, an extra
/// number `entrants` stands for the bye.
///
/// A pairing exists for any results, in each of fewer rounds than entrants. Let n be the even number of
/// places.
/// - At most n / 2 rounds: before each round, everyone has at least n / 2 possible opponents. By Dirac's
///   theorem (1952) the possible meetings contain a cycle through all n; every second edge of it is a
///   pairing.
/// - More rounds: pairings for all remaining rounds are known at any time (`ReservedRounds`).
class SwissPairing {
 public:
  /// @param entrants  at least 2
  /// @param rounds  fewer than entrants
  SwissPairing(std::size_t entrants, std::size_t rounds);

  /// The pairs of the next round in the order of the table, the better entrant first; a bye comes last.
  /// `points` by entrant; equal points rank by number.
  ///
  /// In a group with equal points, the upper half meets the lower half. An entrant without an opponent there
  /// meets the best possible one below. The bye goes to the lowest entrant that had none. A choice is skipped
  /// if the others could not be paired. In a long tournament a choice after which no reserved rounds are
  /// found is replaced by the reserved round with the most equal points.
  Pairing next(const std::vector<double>& points);

 private:
  Pairing preferred(const std::vector<double>& points) const;

  std::size_t entrants_;
  OpenMeetings open_;
  ReservedRounds reserved_;  // empty if the tournament has at most n / 2 rounds
};

}  // namespace fulbito
