#include "tournament/formats/swiss_pairing.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace fulbito {
namespace {

std::size_t evenNumber(std::size_t entrants) { return entrants + entrants % 2; }

std::vector<std::size_t> ranked(const std::vector<double>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return points[a] > points[b]; });
  return order;
}

/// Possible opponents of the first of `waiting`, most suitable first. Within its group of equal points: the
/// lower half from top to bottom, then the rest of the upper half from bottom to top. Then all below the
/// group from top to bottom.
std::vector<std::size_t> preferences(const std::vector<std::size_t>& waiting,
                                     const std::vector<double>& points) {
  const auto below = std::find_if(waiting.begin(), waiting.end(), [&](std::size_t entrant) {
    return points[entrant] != points[waiting.front()];
  });
  const auto half = std::max<std::ptrdiff_t>(1, (below - waiting.begin()) / 2);
  std::vector<std::size_t> choice(waiting.begin() + half, below);
  choice.insert(choice.end(), std::make_reverse_iterator(waiting.begin() + half),
                std::make_reverse_iterator(waiting.begin() + 1));
  choice.insert(choice.end(), below, waiting.end());
  return choice;
}

OpenMeetings without(OpenMeetings open, const Pairing& pairs) {
  for (const auto& [a, b] : pairs) open.close(a, b);
  return open;
}

}  // namespace

SwissPairing::SwissPairing(std::size_t entrants, std::size_t rounds)
    : entrants_(entrants),
      open_(evenNumber(entrants)),
      reserved_(evenNumber(entrants), 2 * rounds > evenNumber(entrants) ? rounds : 0) {}

Pairing SwissPairing::preferred(const std::vector<double>& points) const {
  PerfectMatching matching(open_);
  std::vector<std::size_t> waiting = ranked(points);
  Pairing pairs;
  const auto pair = [&](std::size_t a, const std::vector<std::size_t>& choice) {
    const auto b = std::find_if(choice.begin(), choice.end(),
                                [&](std::size_t other) { return matching.settle(a, other); });
    if (b == choice.end()) return false;
    pairs.emplace_back(a, *b);
    std::erase_if(waiting, [&, other = *b](std::size_t one) { return one == a || one == other; });
    return true;
  };
  const bool odd = open_.size() > entrants_;
  if (odd) pair(entrants_, {waiting.rbegin(), waiting.rend()});
  while (!waiting.empty() && pair(waiting.front(), preferences(waiting, points))) {
  }
  if (odd) {
    std::swap(pairs.front().first, pairs.front().second);
    std::rotate(pairs.begin(), pairs.begin() + 1, pairs.end());
  }
  return pairs;
}

Pairing SwissPairing::next(const std::vector<double>& points) {
  Pairing pairs = preferred(points);
  OpenMeetings after = without(open_, pairs);
  if (!reserved_.empty() && !reserved_.renew(after)) {
    pairs = reserved_.take(points);
    after = without(open_, pairs);
  }
  open_ = std::move(after);
  return pairs;
}

}  // namespace fulbito
