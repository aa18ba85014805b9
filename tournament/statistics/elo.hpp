#pragma once

#include "fulbito/detail/interval.hpp"
#include "tournament/statistics/pentanomial.hpp"

namespace fulbito {

/// Elo points per unit of normalized strength: 800 / ln 10. For nearly equal sides without draws, normalized
/// Elo then equals Elo (M. Van den Bergh, "Normalized Elo").
inline constexpr double kEloPerStrength = 347.43558552260146;

/// Elo difference that expects `score`, strictly between 0 and 1, per match: -400 log10(1 / score - 1).
double eloOf(double score);
/// The score that an Elo difference expects.
double scoreOf(double elo);

/// Normalized strength of a distribution of pair scores: (mean - 1/2) over the standard deviation of a single
/// match's score, which is sqrt(2) that of a pair's. It tells how many matches a proof takes, whatever the
/// share of draws.
double normalizedStrength(const PairMoments& moments);

/// How much stronger the first team is, from pairs of matches.
struct EloEstimate {
  Interval elo;  ///< Elo difference with its 95 % interval; infinite where all pairs are won or lost
  Interval normalized_elo;   ///< normalized Elo with its 95 % interval
  double superiority = 0.5;  ///< probability that the first team is the stronger one (LOS)
};

/// The estimate from counts of pairs, by the normal distribution of the mean score. Without a pair the
/// intervals are infinite.
EloEstimate estimateElo(const PairCounts& counts);

}  // namespace fulbito
