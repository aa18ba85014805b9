#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/core/math/statistics.hpp"
#include "match/config/match_config.hpp"
#include "match/config/match_faults.hpp"

namespace fulbito {

/// A series of matches of the same two teams in swapped pairs: the second leg has the same seed with the
/// seats exchanged. Random numbers belong to seats, so a team against itself gives a goal difference of
/// exactly zero.
struct SeriesConfig {
  MatchConfig match;  ///< the first leg: team A is blue; `seed` is the series' seed
  int pairs = 1;      ///< 1 ... 100,000
  int jobs = 0;       ///< worker threads, 0 ... 1024; 0: all cores. Changes no result.
};

/// One match of a series.
struct LegRecord {
  PerTeam<int> score{};             ///< blue, yellow
  PerTeam<int> goals_after_foul{};  ///< goals of the score within `kFoulPaysWithin` of an own foul
  Tick ticks = 0;
  std::uint64_t hash = 0;  ///< `Match::hash`
  MatchFaults faults;
};

/// Two matches: the statistical unit.
struct PairRecord {
  std::uint64_t seed = 0;         ///< of both matches
  std::array<LegRecord, 2> legs;  ///< A plays blue in the first, yellow in the second

  int goalsOfA() const { return legs[0].score[0] + legs[1].score[1]; }
  int goalsOfB() const { return legs[0].score[1] + legs[1].score[0]; }
  /// Points share of A over both matches, 0 ... 1; a draw counts half.
  double points() const;
};

/// The result of a complete or stopped series.
struct SeriesResult {
  std::vector<PairRecord> pairs;  ///< in the order of the schedule, without gaps
  bool interrupted = false;       ///< fewer pairs than configured
  int wins = 0;                   ///< matches that A won
  int draws = 0;
  int losses = 0;
  int goals_for = 0;
  int goals_against = 0;
  int goals_after_foul_for = 0;  ///< of these, within `kFoulPaysWithin` of an own foul of the scoring team
  int goals_after_foul_against = 0;
  Interval points_share;     ///< of A, 0 ... 1; interval: `shareInterval` over pairs
  Interval goal_difference;  ///< A's goals minus B's, per match; interval: `meanInterval` over pairs
};

/// Called after each match with the number of finished matches. Returning false stops the series. Calls do
/// not overlap.
using SeriesProgress = std::function<bool(std::size_t done, std::size_t total)>;

/// Plays the series. The result does not depend on the number of jobs. If stopped early, it holds the
/// complete pairs before the first gap. Errors: as `Match::create`; kUsage for `pairs` and `jobs`.
Result<SeriesResult> playSeries(const SeriesConfig& config, const SeriesProgress& progress = {});

/// Seed of a pair. The first pair uses the series' seed.
std::uint64_t seedOfPair(std::uint64_t series_seed, std::uint64_t pair);

}  // namespace fulbito
