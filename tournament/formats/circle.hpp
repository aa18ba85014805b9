#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace fulbito {

/// Pairs of numbers; no number is in two pairs.
using Pairing = std::vector<std::pair<std::size_t, std::size_t>>;

/// Round `round` of the circle method for an even number of `places`: place 0 stays, the others turn by one
/// per round. In the places - 1 rounds each two places meet once. Places 0 and 1 meet in the last round.
Pairing circleRound(std::size_t places, std::size_t round);

}  // namespace fulbito
