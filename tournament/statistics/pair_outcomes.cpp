#include "tournament/statistics/pair_outcomes.hpp"

#include <cmath>
#include <numeric>

namespace fulbito {
namespace {

constexpr std::array<PairMatches, kPairOutcomes> kMatches{
    {{0, 0, 2}, {0, 1, 1}, {0, 2, 0}, {1, 0, 1}, {1, 1, 0}, {2, 0, 0}}};

/// Sum of the matches of one kind (wins, draws or losses) over all pairs.
std::int64_t total(const PairOutcomes& pairs, int PairMatches::* kind) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < kPairOutcomes; ++i) sum += pairs.counts[i] * kMatches[i].*kind;
  return sum;
}

/// A match's points in halves: 0 for a loss, 1 for a draw, 2 for a win.
std::size_t halves(double points) { return static_cast<std::size_t>(std::floor(2.0 * points + 0.5)); }

PairOutcome pairOutcome(double first, double second) {
  const std::size_t a = halves(first), b = halves(second);
  if (a + b == 2) return a == 1 ? PairOutcome::kDD : PairOutcome::kWL;
  constexpr std::array<PairOutcome, 5> kBySum{PairOutcome::kLL, PairOutcome::kLD, PairOutcome::kDD,
                                              PairOutcome::kWD, PairOutcome::kWW};
  return kBySum[a + b];
}

}  // namespace

PairMatches matchesOf(PairOutcome outcome) { return kMatches[static_cast<std::size_t>(outcome)]; }

void PairOutcomes::add(double first, double second) {
  ++counts[static_cast<std::size_t>(pairOutcome(first, second))];
}

std::int64_t PairOutcomes::pairs() const {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

std::int64_t PairOutcomes::wins() const { return total(*this, &PairMatches::wins); }
std::int64_t PairOutcomes::draws() const { return total(*this, &PairMatches::draws); }
std::int64_t PairOutcomes::losses() const { return total(*this, &PairMatches::losses); }

PairCounts PairOutcomes::scores() const {
  PairCounts scores;
  for (std::size_t i = 0; i < kPairOutcomes; ++i) {
    const int quarters = 2 * kMatches[i].wins + kMatches[i].draws;
    scores.counts[static_cast<std::size_t>(quarters)] += counts[i];
  }
  return scores;
}

}  // namespace fulbito
