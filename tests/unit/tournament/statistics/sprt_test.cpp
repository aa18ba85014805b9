#include "tournament/statistics/sprt.hpp"

#include <array>
#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tournament/statistics/elo.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr PairDistribution kTypical{0.10, 0.22, 0.36, 0.22, 0.10};

double logLikelihood(const PairDistribution& frequencies, const PairDistribution& model) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kPairScores; ++i) sum += frequencies[i] * math::log(model[i]);
  return sum;
}

double pointsFrom(const PairDistribution& distribution, Rng& rng) {
  double left = rng.uniform(0.0, 1.0);
  for (std::size_t i = 0; i + 1 < kPairScores; ++i) {
    left -= distribution[i];
    if (left < 0.0) return pairScore(i);
  }
  return 1.0;
}

struct Outcomes {
  int passed = 0, failed = 0;
  double pairs = 0.0;  // mean number of pairs
};

Outcomes simulate(const PairDistribution& truth, const SprtBounds& bounds, int tests, std::uint64_t seed) {
  Outcomes outcomes;
  for (int i = 0; i < tests; ++i) {
    Rng rng(seed, kTestStream, static_cast<std::uint64_t>(i));
    Sprt sprt(bounds);
    while (sprt.verdict() == SprtVerdict::kInconclusive) sprt.add(pointsFrom(truth, rng));
    ++(sprt.verdict() == SprtVerdict::kPass ? outcomes.passed : outcomes.failed);
    outcomes.pairs += static_cast<double>(sprt.counts().pairs()) / tests;
  }
  return outcomes;
}

// The likeliest distribution with this normalized Elo, given typical frequencies.
PairDistribution strengthOf(double normalized_elo) {
  return likeliestDistribution(kTypical, normalized_elo / kEloPerStrength);
}

}  // namespace

TEST_CASE("the likeliest distribution has the wanted strength and is one", "[unit]") {
  const std::array<PairDistribution, 3> all{
      {kTypical, {0.01, 0.04, 0.15, 0.3, 0.5}, {0.001, 0.001, 0.996, 0.001, 0.001}}};
  const PairDistribution frequencies = all[GENERATE(0u, 1u, 2u)];
  for (const double strength : {-0.3, -0.05, 0.0, 0.1, 0.4}) {
    const PairDistribution likeliest = likeliestDistribution(frequencies, strength);
    CAPTURE(strength);
    double sum = 0.0;
    for (const double p : likeliest) {
      CHECK(p > 0.0);
      sum += p;
    }
    CHECK(sum == Approx(1.0).margin(1e-8));
    CHECK(normalizedStrength(momentsOf(likeliest)) == Approx(strength).margin(1e-6));
  }
}

TEST_CASE("no distribution of the same strength is likelier", "[unit]") {
  Rng rng(3, kTestStream);
  const double strength = 0.1;
  const double best = logLikelihood(kTypical, likeliestDistribution(kTypical, strength));
  for (int i = 0; i < 500; ++i) {
    // Other frequencies give another distribution with the same strength.
    PairDistribution other{};
    double sum = 0.0;
    for (double& share : other) sum += share = rng.uniform(0.02, 1.0);
    for (double& share : other) share /= sum;
    CHECK(logLikelihood(kTypical, likeliestDistribution(other, strength)) <= best + 1e-9);
  }
}

TEST_CASE("the ratio is 0 half-way, and near its known approximation for many pairs", "[unit]") {
  const SprtBounds bounds{-20.0, 20.0, 0.05, 0.05};
  PairCounts even;
  even.counts = {100, 220, 360, 220, 100};
  CHECK(logLikelihoodRatio(even, bounds) == Approx(0.0).margin(1e-6));
  CHECK(logLikelihoodRatio({}, bounds) == 0.0);
  // Approximation for small strengths: n / 2 (t1 - t0) (2 t - t0 - t1), with strengths t per pair.
  PairCounts better;
  better.counts = {90, 210, 360, 230, 110};
  const double t = normalizedStrength(momentsOf(distributionOf(better))) * std::sqrt(2.0);
  const double t1 = 20.0 / kEloPerStrength * std::sqrt(2.0), t0 = -t1;
  CHECK(logLikelihoodRatio(better, bounds) ==
        Approx(1000.0 / 2 * (t1 - t0) * (2 * t - t0 - t1)).epsilon(0.02));
}

TEST_CASE("both error rates are at most 5 %, and the pairs that a test takes are as published", "[unit]") {
  const SprtBounds bounds{-50.0, 0.0, 0.05, 0.05};
  constexpr int kTests = 2000;
  const Outcomes weak = simulate(strengthOf(-50.0), bounds, kTests, 1);
  const Outcomes strong = simulate(strengthOf(0.0), bounds, kTests, 2);
  // One-sided 99.9 % interval of a rate of 5 % in 2,000 tests: 3.09 sqrt(0.05 * 0.95 / 2000) = 0.015.
  CHECK(weak.passed <= kTests * 0.065);
  CHECK(strong.failed <= kTests * 0.065);
  // An independent simulation of 400 tests needed 135 pairs on average.
  CHECK(weak.pairs == Approx(135).epsilon(0.1));
  CHECK(strong.pairs == Approx(135).epsilon(0.1));
}

TEST_CASE("a verdict is final", "[unit]") {
  Sprt sprt({0.0, 100.0, 0.05, 0.05});
  while (sprt.verdict() == SprtVerdict::kInconclusive) sprt.add(1.0);
  CHECK(sprt.verdict() == SprtVerdict::kPass);
  const auto pairs = sprt.counts().pairs();
  for (int i = 0; i < 100; ++i) sprt.add(0.0);
  CHECK(sprt.verdict() == SprtVerdict::kPass);
  CHECK(sprt.counts().pairs() == pairs);
}

TEST_CASE("identical results never end a test by an accident of arithmetic", "[unit]") {
  Sprt draws({0.0, 25.0, 0.05, 0.05});
  for (int i = 0; i < 200; ++i) {
    draws.add(0.5);
    CHECK(std::isfinite(draws.ratio()));
  }
}
