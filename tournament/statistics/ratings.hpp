#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "tournament/statistics/pentanomial.hpp"

namespace fulbito {

/// All pairs of one meeting of two entrants: pairs by A's points, and single matches.
struct MeetingCounts {
  std::size_t a = 0, b = 0;             ///< indices of the entrants, a < b
  PairCounts pairs;                     ///< by A's points
  int wins = 0, draws = 0, losses = 0;  ///< matches, of A
};

/// The ratings of many entrants.
struct Ratings {
  /// Elo by entrant with 95 % intervals; their mean is 0. Infinite bounds without a pair.
  std::vector<Interval> elo;
  double draw_elo = 0.0;  ///< advantage that the model gives to draws, in Elo
  /// Probability that the entrant of the row is stronger than that of the column (superiority); 1/2 on the
  /// diagonal.
  std::vector<std::vector<double>> superiority;
  /// Whether ratings needed the prior: an entrant, or a group of them, won or lost everything.
  bool prior = false;
  /// Groups of entrants that met each other, directly or not; ratings compare within a group only. By
  /// entrant, from 0.
  std::vector<int> component;
};

/// Maximum-likelihood ratings with draws (Davidson's model), with intervals and superiority from a bootstrap
/// over pairs. Pure: the bootstrap draws from `seed`.
Ratings rate(std::size_t entrants, std::span<const MeetingCounts> meetings, std::uint64_t seed,
             std::size_t resamples = 1000);

}  // namespace fulbito
