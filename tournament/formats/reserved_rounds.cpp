#include "tournament/formats/reserved_rounds.hpp"

#include <algorithm>
#include <numeric>

namespace fulbito {
namespace {

using Mates = std::vector<std::size_t>;
using Points = std::vector<double>;

constexpr std::size_t kMostRenewed = 64;  // places: for more, the search takes too long
constexpr std::size_t kAttempts = 8;      // the first attempt mostly succeeds
constexpr int kMostSweeps = 20;  // bounds the time of long tournaments; a few sweeps are usually enough

Mates matesOf(const Pairing& pairs) {
  Mates mates(2 * pairs.size());
  for (const auto& [a, b] : pairs) mates[a] = b, mates[b] = a;
  return mates;
}

/// Square of the difference in points. Points are multiples of 1/4, so sums of squares are exact.
double costOf(const Points& points, std::size_t a, std::size_t b) {
  const double difference = points[a] - points[b];
  return difference * difference;
}

double costOf(const Points& points, const Mates& mates) {
  double cost = 0.0;
  for (std::size_t i = 0; i < mates.size(); ++i) cost += costOf(points, i, mates[i]);
  return cost;
}

/// The places on the cycle through `start` whose edges alternate between meetings of both rounds.
std::vector<std::size_t> cycleThrough(std::size_t start, const Mates& round, const Mates& other) {
  std::vector<std::size_t> cycle;
  std::size_t place = start;
  do {
    cycle.push_back(place);
    cycle.push_back(round[place]);
    place = other[round[place]];
  } while (place != start);
  return cycle;
}

/// Exchanges each cycle that pairs `round` by more equal points. Returns whether there was one.
bool exchangeCycles(const Points& points, Mates& round, Mates& other) {
  bool better = false;
  std::vector<bool> seen(round.size());
  for (std::size_t start = 0; start < round.size(); ++start) {
    if (seen[start]) continue;
    const auto cycle = cycleThrough(start, round, other);
    double gain = 0.0;
    for (const std::size_t place : cycle) {
      seen[place] = true;
      gain += costOf(points, place, round[place]) - costOf(points, place, other[place]);
    }
    if (gain <= 0.0) continue;
    for (const std::size_t place : cycle) std::swap(round[place], other[place]);
    better = true;
  }
  return better;
}

/// The pairs of a round, better entrant first, sorted by the points of the better entrant. A bye comes last.
Pairing pairsOf(const Mates& mates, const Points& points) {
  const auto better = [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] > points[b] : a < b;
  };
  Pairing pairs;
  for (std::size_t i = 0; i < mates.size(); ++i) {
    if (better(i, mates[i])) pairs.emplace_back(i, mates[i]);
  }
  std::sort(pairs.begin(), pairs.end(),
            [&](const auto& one, const auto& two) { return better(one.first, two.first); });
  return pairs;
}

/// Takes pairings out of the possible meetings one after the other. Returns fewer than `count` if no more
/// exist.
std::vector<Mates> disjointRounds(OpenMeetings open, std::size_t count, std::size_t first_sum) {
  std::vector<Mates> rounds;
  while (rounds.size() < count) {
    const PerfectMatching matching(open, first_sum + rounds.size());
    if (!matching.exists()) break;
    rounds.push_back(matching.opponents());
    for (std::size_t i = 0; i < open.size(); ++i) open.close(i, rounds.back()[i]);
  }
  return rounds;
}

}  // namespace

ReservedRounds::ReservedRounds(std::size_t places, std::size_t rounds) {
  rounds_.reserve(rounds);
  for (std::size_t round = 0; round < rounds; ++round) rounds_.push_back(matesOf(circleRound(places, round)));
}

bool ReservedRounds::renew(const OpenMeetings& after_next) {
  if (after_next.size() > kMostRenewed) return false;
  const std::size_t count = rounds_.size() - 1;
  for (std::size_t attempt = 0; attempt < kAttempts; ++attempt) {
    auto rounds = disjointRounds(after_next, count, attempt);
    if (rounds.size() < count) continue;
    rounds_ = std::move(rounds);
    return true;
  }
  return false;
}

Pairing ReservedRounds::take(std::vector<double> points) {
  const std::size_t entrants = points.size();
  const bool absent = entrants < rounds_.front().size();
  if (absent) points.push_back(*std::min_element(points.begin(), points.end()));
  const auto best = std::min_element(rounds_.begin(), rounds_.end(), [&](const Mates& a, const Mates& b) {
    return costOf(points, a) < costOf(points, b);
  });
  Mates round = std::move(*best);
  rounds_.erase(best);
  bool better = true;
  for (int sweep = 0; better && sweep < kMostSweeps; ++sweep) {
    better = false;
    for (Mates& other : rounds_) better = exchangeCycles(points, round, other) || better;
  }
  Pairing pairs = pairsOf(round, points);
  if (absent) {
    const auto bye =
        std::find_if(pairs.begin(), pairs.end(), [&](auto& pair) { return pair.second == entrants; });
    std::rotate(bye, bye + 1, pairs.end());
  }
  return pairs;
}

}  // namespace fulbito
