#pragma once

#include "fulbito/detail/interval.hpp"
#include "tournament/statistics/pentanomial.hpp"

namespace fulbito {

/// Elo points per unit of normalized strength: 800 / ln 10. For nearly equal sides without draws, normalized
/// Elo then equals Elo (M. Van den Bergh, "Normalized Elo").
inline constexpr double kEloPerStrength = 347.43558552260146;

/// Elo difference with the expected score `score` per match, strictly between 0 and 1: -400 log10(1 / score -
/// 1).
double eloOf(double score);
/// The expected score per match at an Elo difference.
double scoreOf(double elo);

/// Normalized strength of a distribution of pair scores: (mean - 1/2) over the standard deviation of a single
/// match's score, which is sqrt(2) times that of a pair's score. It determines how many matches a test needs,
/// whatever the share of draws.
double normalizedStrength(const PairMoments& moments);

/// Estimate of how much stronger the first team is, from pairs of matches.
struct EloEstimate {
  Interval elo;  ///< Elo difference with 95 % interval; infinite if all pairs are won or all are lost
  Interval normalized_elo;  ///< normalized Elo with 95 % interval
  /// Probability that the first team is the stronger one (likelihood of superiority, LOS).
  double superiority = 0.5;
};

/// The estimate from counts of pairs, with a normal distribution of the mean score. Without pairs the
/// intervals are infinite.
EloEstimate estimateElo(const PairCounts& counts);

}  // namespace fulbito
