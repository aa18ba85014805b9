#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/core/math/statistics.hpp"
#include "match/config/match_config.hpp"
#include "match/config/match_faults.hpp"

namespace fulbito {

/// Many matches of the same two teams, in swapped pairs: the second leg has the same seed with the seats
/// exchanged. Random numbers belong to the seats, so that a team against itself gives exactly zero.
struct SeriesConfig {
  MatchConfig match;  ///< of the first leg: team A is blue; `seed` is the series' seed
  int pairs = 1;      ///< 1 ... 100,000
  int jobs = 0;       ///< worker threads, 0 ... 1024; 0: all cores. Changes no result.
};

/// One match of a series.
struct LegRecord {
  PerTeam<int> score{};             ///< blue, yellow
  PerTeam<int> goals_after_foul{};  ///< of the score, within `kFoulPaysWithin` of an own foul
  Tick ticks = 0;
  std::uint64_t hash = 0;  ///< `Match::hash`
  MatchFaults faults;
};

/// Two matches: the unit of the statistics.
struct PairRecord {
  std::uint64_t seed = 0;         ///< of both matches
  std::array<LegRecord, 2> legs;  ///< A plays blue in the first, yellow in the second

  int goalsOfA() const { return legs[0].score[0] + legs[1].score[1]; }
  int goalsOfB() const { return legs[0].score[1] + legs[1].score[0]; }
  /// Of A, 0 ... 1: wins and half of the draws over both matches.
  double points() const;
};

/// A series as far as it was played.
struct SeriesResult {
  std::vector<PairRecord> pairs;  ///< in the order of the schedule, without a gap
  bool interrupted = false;       ///< fewer pairs than wanted
  int wins = 0;                   ///< matches that A won
  int draws = 0;
  int losses = 0;
  int goals_for = 0;
  int goals_against = 0;
  int goals_after_foul_for = 0;  ///< of these, within `kFoulPaysWithin` of an own foul of who scored
  int goals_after_foul_against = 0;
  Interval points_share;     ///< of A, 0 ... 1; interval: `shareInterval` over pairs
  Interval goal_difference;  ///< A's goals less B's, a match; interval: `meanInterval` over pairs
};

/// Called with the number of finished matches after each; returning false stops the series. Not called by two
/// threads at once.
using SeriesProgress = std::function<bool(std::size_t done, std::size_t total)>;

/// Plays the series. Whatever the number of jobs, the result is the same; stopped early, it holds the pairs
/// that were complete without a gap. Errors: as `Match::create`, and kUsage of pairs and jobs.
Result<SeriesResult> playSeries(const SeriesConfig& config, const SeriesProgress& progress = {});

/// Seed of a pair: the first pair plays the series' own.
std::uint64_t seedOfPair(std::uint64_t series_seed, std::uint64_t pair);

}  // namespace fulbito
