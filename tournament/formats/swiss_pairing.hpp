#pragma once

#include <vector>

#include "tournament/formats/circle.hpp"
#include "tournament/formats/perfect_matching.hpp"
#include "tournament/formats/reserved_rounds.hpp"

namespace fulbito {

/// Pairs a Swiss tournament round by round; nobody meets twice. With an odd number of entrants, an absent one
/// of the number `entrants` makes the number even: who is paired with it has a bye.
///
/// A pairing always exists, for any results, in each of fewer rounds than entrants. Let n be the even number.
/// - At most n / 2 rounds: before each, everyone has at least n / 2 possible opponents. By Dirac's theorem
/// (1952)
///   the possible meetings contain a cycle through all n, and every second one of it is a pairing.
/// - More rounds: pairings for all rounds to come are known at any time (`ReservedRounds`).
class SwissPairing {
 public:
  /// Fewer rounds than entrants; at least 2 entrants.
  SwissPairing(std::size_t entrants, std::size_t rounds);

  /// The pairs of the next round, the better entrant first, in the order of the table; a bye comes last.
  /// `points` by entrant; equal points rank by number.
  ///
  /// Of a group with equal points, the upper half meets the lower half; who finds no opponent there meets
  /// the best possible one below. The bye goes to the last who had none. A choice that leaves the others
  /// without a pairing is passed over. A long tournament, for which no later rounds are found after this
  /// choice, plays the reserved round with the most equal points instead.
  Pairing next(const std::vector<double>& points);

 private:
  Pairing preferred(const std::vector<double>& points) const;

  std::size_t entrants_;
  OpenMeetings open_;
  ReservedRounds reserved_;  // empty for few rounds
};

}  // namespace fulbito
