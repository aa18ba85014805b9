#include <queue>
#include <utility>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tournament/statistics/elo.hpp"
#include "tournament/statistics/sprt.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

/// Half of this difference would need 3.4 times as many pairs, and too much time.
constexpr SprtBounds kBounds{0.0, 100.0, 0.05, 0.05};
constexpr int kTests = 500;
/// One-sided 99.9 % interval of a rate of 5 % in 500 tests: 0.05 + 3.09 sqrt(0.05 * 0.95 / 500) = 0.080.
constexpr double kMostErrors = kTests * 0.080;
constexpr PairDistribution kTypical{0.10, 0.22, 0.36, 0.22, 0.10};

/// The points of a pair in a simulated tournament. They do not depend on the worker or the time.
double pointsOf(std::uint64_t tournament, std::uint64_t pair, const PairDistribution& truth) {
  Rng rng(tournament, kTestStream, pair);
  double left = rng.uniform();
  for (std::size_t i = 0; i + 1 < kPairScores; ++i) {
    left -= truth[i];
    if (left < 0.0) return pairScore(i);
  }
  return 1.0;
}

/// Duration of a pair by its points: from 1 for a lost pair to `winning` for a won pair.
double durationOf(double points, double winning) { return 1.0 + points * (winning - 1.0); }

/// Pairs in order of completion, played by several workers. A worker takes the next pair of the schedule when
/// its last one has ended.
class Workers {
 public:
  Workers(std::size_t count, double winning, std::uint64_t tournament, const PairDistribution& truth)
      : winning_(winning), tournament_(tournament), truth_(truth) {
    for (std::size_t i = 0; i < count; ++i) begin(0.0);
  }

  /// The next pair that ends, with its points.
  std::pair<std::size_t, double> next() {
    const Running ended = running_.top();
    running_.pop();
    begin(ended.end);
    return {ended.pair, ended.points};
  }

 private:
  struct Running {
    double end;
    std::size_t pair;
    double points;
    bool operator<(const Running& other) const {
      return std::pair(end, pair) > std::pair(other.end, other.pair);
    }
  };

  void begin(double time) {
    const double points = pointsOf(tournament_, next_, truth_);
    running_.push({time + durationOf(points, winning_), next_, points});
    ++next_;
  }

  double winning_;
  std::uint64_t tournament_;
  PairDistribution truth_;
  std::size_t next_ = 0;
  std::priority_queue<Running> running_;
};

/// A test that gets results in the order of the schedule: a result waits until all earlier ones exist.
Sprt inOrderOfSchedule(Workers workers) {
  Sprt sprt(kBounds);
  std::vector<double> points;  // by pair; negative: not played yet
  for (std::size_t counted = 0; sprt.verdict() == SprtVerdict::kInconclusive;) {
    const auto [pair, result] = workers.next();
    if (points.size() <= pair) points.resize(pair + 1, -1.0);
    points[pair] = result;
    while (counted < points.size() && points[counted] >= 0.0) sprt.add(points[counted++]);
  }
  return sprt;
}

Sprt inOrderOfCompletion(Workers workers) {
  Sprt sprt(kBounds);
  while (sprt.verdict() == SprtVerdict::kInconclusive) sprt.add(workers.next().second);
  return sprt;
}

PairDistribution strengthOf(double normalized_elo) {
  return likeliestDistribution(kTypical, normalized_elo / kEloPerStrength);
}

}  // namespace

TEST_CASE("in the order of the schedule the verdict is the same for any number of workers and errs rarely",
          "[unit]") {
  const double winning = GENERATE(0.5, 0.1);
  int passed_if_weak = 0, failed_if_strong = 0;
  for (std::uint64_t test = 0; test < kTests; ++test) {
    for (const double strength : {kBounds.weak, kBounds.strong}) {
      const PairDistribution truth = strengthOf(strength);
      const Sprt alone = inOrderOfSchedule(Workers(1, winning, 2 * test, truth));
      for (const std::size_t workers : {16u, 64u}) {
        const Sprt many = inOrderOfSchedule(Workers(workers, winning, 2 * test, truth));
        REQUIRE(many.verdict() == alone.verdict());
        REQUIRE(many.counts().counts == alone.counts().counts);
        REQUIRE(many.ratio() == alone.ratio());
      }
      passed_if_weak += strength == kBounds.weak && alone.verdict() == SprtVerdict::kPass;
      failed_if_strong += strength == kBounds.strong && alone.verdict() == SprtVerdict::kFail;
    }
  }
  INFO("run time " << winning << ", order of schedule: " << passed_if_weak << " and " << failed_if_strong
                   << " errors of " << kTests);
  CHECK(passed_if_weak <= kMostErrors);
  CHECK(failed_if_strong <= kMostErrors);
}

TEST_CASE("in order of completion a test errs far more often than its nominal rate", "[unit]") {
  const PairDistribution equal = strengthOf(0.0);
  const auto errors = [&](std::size_t workers, double winning) {
    int passed = 0;
    for (std::uint64_t test = 0; test < kTests; ++test) {
      const Sprt sprt = inOrderOfCompletion(Workers(workers, winning, 2 * test, equal));
      passed += sprt.verdict() == SprtVerdict::kPass;
    }
    INFO(workers << " workers, run time " << winning << ", order of completion: " << passed << " errors of "
                 << kTests);
    return passed;
  };
  CHECK(errors(1, 0.1) <= kMostErrors);  // with a single worker both orders are the same
  CHECK(errors(16, 0.1) > kTests * 0.15);
  CHECK(errors(64, 0.5) > kTests * 0.5);
  CHECK(errors(64, 0.1) > kTests * 0.9);
}
