#pragma once

#include <cstdint>
#include <string_view>

#include "tournament/statistics/pentanomial.hpp"

namespace fulbito {

/// Largest absolute normalized strength of a hypothesis: 200 normalized Elo.
inline constexpr double kMostStrength = 0.576;

/// A sequential test of two hypotheses about the strength of a new team against its base, in normalized Elo.
struct SprtBounds {
  double weak = -50.0;  ///< normalized Elo of H0
  double strong = 0.0;  ///< normalized Elo of H1, greater than `weak`
  double alpha = 0.05;  ///< largest probability that H1 is accepted while H0 is true
  double beta = 0.05;   ///< largest probability that H0 is accepted while H1 is true

  /// H0 is accepted at or below this log-likelihood ratio: log(beta / (1 - alpha)).
  double lower() const;
  /// H1 is accepted at or above this log-likelihood ratio: log((1 - beta) / alpha).
  double upper() const;
};

/// The verdicts of a test.
enum class SprtVerdict : std::uint8_t {
  kPass,         ///< H1 is accepted
  kFail,         ///< H0 is accepted
  kInconclusive  ///< neither is accepted yet
};
/// "pass", "fail", "inconclusive".
std::string_view nameOf(SprtVerdict verdict);

/// Log-likelihood ratio of H1 to H0 for counts of pairs: the generalized sequential probability ratio test. A
/// hypothesis only fixes the normalized strength, so its likeliest distribution of pair scores stands for it.
/// 0 without pairs.
double logLikelihoodRatio(const PairCounts& counts, const SprtBounds& bounds);

/// The likeliest distribution of pair scores with the normalized strength `strength`, given positive
/// frequencies. The absolute strength is at most `kMostStrength`.
PairDistribution likeliestDistribution(const PairDistribution& frequencies, double strength);

/// A running test. Results must come in the order of the schedule: in order of completion, short matches
/// would come first and raise the error rates.
class Sprt {
 public:
  explicit Sprt(const SprtBounds& bounds) : bounds_(bounds) {}

  /// Adds the points of the next pair. Has no effect after a verdict.
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
