#include "tournament/formats/circle.hpp"

#include <algorithm>

namespace fulbito {

Pairing circleRound(std::size_t places, std::size_t round) {
  const std::size_t turning = places - 1;
  const auto at = [&](std::size_t i) {
    return i == 0 ? 0 : 1 + (i - 1 + turning - round % turning) % turning;
  };
  Pairing pairs;
  pairs.reserve(places / 2);
  for (std::size_t i = 0; i < places / 2; ++i) {
    pairs.push_back(std::minmax({at(i), at(places - 1 - i)}));
  }
  return pairs;
}

}  // namespace fulbito
