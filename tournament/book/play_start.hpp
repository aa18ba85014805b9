#pragma once

#include "tournament/book/book.hpp"

namespace fulbito {

/// A state from the middle of play between two sparring teams under the rules of the match: the ball rolls,
/// no bodies overlap, and play went on for at least half a second from there without a call. A placement has
/// no speeds of robots: they start at rest. Absent teams have no robots. Errors: kBadInput when 20 matches
/// have no such state; as `Match::create`.
Result<Placement> playStart(const StartKey& key, const MatchConfig& match);

}  // namespace fulbito
