#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "tournament/statistics/pair_outcomes.hpp"

namespace fulbito {

/// The pairs that two entrants played. Several of these with the same entrants add up.
struct MeetingCounts {
  std::size_t a = 0, b = 0;  ///< indices of the entrants; ignored if equal
  PairOutcomes pairs;        ///< outcomes from the view of A
};

/// The ratings of many entrants.
struct Ratings {
  /// Elo by entrant with 95 % intervals; the mean of each component is 0. A lead of 400 means ten wins per
  /// loss; `expectedPoints` gives the expected score. Without pairs the bounds are infinite.
  std::vector<Interval> elo;
  /// Probability of a draw between equal entrants in the model, 0 ... 1.
  double draw_share = 0.0;
  /// Probability that the entrant of the row is stronger than that of the column (superiority); 1/2 on the
  /// diagonal and between components.
  std::vector<std::vector<double>> superiority;
  /// Whether a prior was added, because the results alone have no most likely ratings: an entrant or a group
  /// won or lost everything against the rest. The prior gives each entrant of the component half a pair, won
  /// once and lost once, against a fictitious entrant of average strength. `winGraph` has the exact
  /// condition.
  bool prior = false;
  /// Number of the component, from 0, by entrant: a group of entrants that met each other, directly or
  /// indirectly. Ratings of different components cannot be compared.
  std::vector<int> component;
};

/// Expected points per match (wins plus half of the draws) at a lead of `elo`, by Davidson's model.
/// `draw_share` is the probability of a draw between equal entrants.
double expectedPoints(double elo, double draw_share);

/// Maximum-likelihood ratings with draws: P(i beats j) = p_i / (p_i + p_j + nu sqrt(p_i p_j)), Elo = 400
/// log10 p (R. R. Davidson, 1970). Strengths and nu are estimated jointly.
///
/// Intervals and superiority come from a Bayesian bootstrap over pairs (D. B. Rubin, 1981). Each resample
/// gives every pair a random weight, drawn from `seed`, with mean 1 and variance n / (n - k). Here n is the
/// number of pairs and k that of differences of ratings in the component. Drawing pairs of each meeting with
/// replacement would make the intervals of meetings with one pair too narrow. Without resamples the bounds
/// are infinite and superiority is 1/2. The order of meetings does not matter.
Ratings rate(std::size_t entrants, std::span<const MeetingCounts> meetings, std::uint64_t seed,
             std::size_t resamples = 1000);

/// A result of two entrants in a unit, such as a layout. Units are independent of each other; results in the
/// same unit are not.
struct UnitResult {
  std::size_t unit = 0;      ///< from 0
  std::size_t a = 0, b = 0;  ///< indices of two different entrants
  double points = 0.5;       ///< points of A: 0, 1/2 or 1
};

/// Ratings as `rate`, from results in units, with a bootstrap over units.
Ratings rateUnits(std::size_t entrants, std::size_t units, std::span<const UnitResult> results,
                  std::uint64_t seed, std::size_t resamples = 1000);

}  // namespace fulbito
