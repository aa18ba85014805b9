#pragma once

#include <cstdint>
#include <string_view>

#include "tournament/statistics/pentanomial.hpp"

namespace fulbito {

/// Largest normalized strength of a hypothesis: 200 normalized Elo.
inline constexpr double kMostStrength = 0.576;

/// A sequential test of two hypotheses about the strength of a new team against its base, in normalized Elo.
struct SprtBounds {
  double weak = -50.0;  ///< normalized Elo of H0
  double strong = 0.0;  ///< normalized Elo of H1, greater than `weak`
  double alpha = 0.05;  ///< most often that H1 is accepted while H0 is true
  double beta = 0.05;   ///< most often that H0 is accepted while H1 is true

  /// H0 is accepted at or below this log-likelihood ratio: log(beta / (1 - alpha)).
  double lower() const;
  /// H1 is accepted at or above this log-likelihood ratio: log((1 - beta) / alpha).
  double upper() const;
};

/// The verdicts of a test.
enum class SprtVerdict : std::uint8_t {
  kPass,         ///< H1 is accepted
  kFail,         ///< H0 is accepted
  kInconclusive  ///< neither is, yet
};
/// "pass", "fail", "inconclusive".
std::string_view nameOf(SprtVerdict verdict);

/// Log-likelihood ratio of H1 to H0 for counts of pairs: the generalized sequential probability ratio test.
/// Each hypothesis fixes the normalized strength only, so each is represented by its likeliest distribution
/// of pair scores. 0 without a pair.
double logLikelihoodRatio(const PairCounts& counts, const SprtBounds& bounds);

/// The likeliest distribution of pair scores with the normalized strength `strength`, at most
/// kMostStrength either way, given frequencies that are all positive.
PairDistribution likeliestDistribution(const PairDistribution& frequencies, double strength);

/// A running test. Results must come in the order of the schedule: in order of completion, fast results come
/// first and the error rates grow.
class Sprt {
 public:
  explicit Sprt(const SprtBounds& bounds) : bounds_(bounds) {}

  /// Takes the points of the next pair. After a verdict it changes nothing.
  void add(double points);

  const PairCounts& counts() const { return counts_; }
  double ratio() const { return ratio_; }  ///< log-likelihood ratio
  SprtVerdict verdict() const { return verdict_; }
  const SprtBounds& bounds() const { return bounds_; }

 private:
  SprtBounds bounds_;
  PairCounts counts_;
  double ratio_ = 0.0;
  SprtVerdict verdict_ = SprtVerdict::kInconclusive;
};

}  // namespace fulbito
