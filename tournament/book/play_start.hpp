#pragma once

#include "tournament/book/book.hpp"

namespace fulbito {

/// A state from the middle of play between two sparring teams under the rules of the match. In it the ball
/// rolls, no bodies overlap, and play went on for at least half a second without a call. Robots start at
/// rest, because a placement has no robot speeds. Absent teams have no robots. Errors: kBadInput when 20
/// matches have no such state; as `Match::create`.
Result<Placement> playStart(const StartKey& key, const MatchConfig& match);

}  // namespace fulbito
