#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "tournament/statistics/pair_outcomes.hpp"

namespace fulbito {

/// All pairs of one meeting of two entrants. Further meetings of the same two add up.
struct MeetingCounts {
  std::size_t a = 0, b = 0;  ///< indices of the entrants; a meeting of one with itself counts nothing
  PairOutcomes pairs;        ///< as A sees them
};

/// The ratings of many entrants.
struct Ratings {
  /// Elo by entrant with 95 % intervals; the mean of each component is 0. A lead of 400 means ten wins a
  /// loss; `expectedPoints` tells the score. Infinite bounds without a pair.
  std::vector<Interval> elo;
  /// The share of draws that the model expects between equal entrants, 0 ... 1.
  double draw_share = 0.0;
  /// Probability that the entrant of the row is stronger than that of the column (superiority); 1/2 on the
  /// diagonal and between components.
  std::vector<std::vector<double>> superiority;
  /// Whether the results alone have no most likely ratings: an entrant, or a group of them, won or lost
  /// everything against the rest. Then each of its component also has half a pair, won once and lost once,
  /// against a fictitious entrant of average strength. See winGraph for the exact condition.
  bool prior = false;
  /// Groups of entrants that met each other, directly or not; ratings compare within a group only. By
  /// entrant, from 0.
  std::vector<int> component;
};

/// The points that an entrant with a lead of `elo` expects per match where equals draw `draw_share` of their
/// matches: its wins plus half of its draws, by Davidson's model.
double expectedPoints(double elo, double draw_share);

/// Maximum-likelihood ratings with draws: P(i beats j) = p_i / (p_i + p_j + nu sqrt(p_i p_j)), Elo = 400
/// log10 p (R. R. Davidson, 1970). Strengths and nu are estimated jointly.
///
/// Intervals and superiority come from a Bayesian bootstrap over pairs (D. B. Rubin, 1981): each resample
/// gives every pair a random weight, from `seed`. It has mean 1 and the variance n / (n - k), for n pairs and
/// k differences of ratings in the component. Drawing pairs of each meeting with replacement would make the
/// intervals of meetings with one pair too narrow. Without resamples the bounds are infinite and superiority
/// is 1/2. Pure, and the same for any order of meetings.
Ratings rate(std::size_t entrants, std::span<const MeetingCounts> meetings, std::uint64_t seed,
             std::size_t resamples = 1000);

/// A result of two entrants in a unit, such as a layout: units are independent of each other, the results
/// within one are not.
struct UnitResult {
  std::size_t unit = 0;      ///< from 0
  std::size_t a = 0, b = 0;  ///< indices of two different entrants
  double points = 0.5;       ///< A's: 0, 1/2 or 1
};

/// The same ratings from results in units, with a bootstrap over units.
Ratings rateUnits(std::size_t entrants, std::size_t units, std::span<const UnitResult> results,
                  std::uint64_t seed, std::size_t resamples = 1000);

}  // namespace fulbito
