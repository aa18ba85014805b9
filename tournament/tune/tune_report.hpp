#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tournament/statistics/elo.hpp"
#include "tournament/tune/tune_run.hpp"

namespace fulbito {

/// What a final match-up shows about its first team, at a confidence of 95 %.
enum class Improvement : std::uint8_t {
  kShown,     ///< the whole interval is above 0
  kNotShown,  ///< 0 is in the interval
  kWorse      ///< the whole interval is below 0
};
/// "shown", "not shown", "worse".
std::string_view nameOf(Improvement improvement);
/// Judges a difference by its interval.
Improvement improvementOf(const Interval& difference);

/// The gain against the opponent: mean difference of the points per match of the tuned team and the start
/// team, over the same starts, with Student's t interval. Empty without an opponent or its results.
std::optional<Interval> gainOf(const TuneOutcome& outcome);

/// The report for people: parameters, specification of the tuned team, final match-ups. Also for an
/// unfinished tuning.
std::string tuneText(const TunePlan& plan, const TuneOutcome& outcome);

/// The report as JSON (docs/results-format.md), with a line end. Equal tunings give equal bytes.
std::string tuneJson(const TunePlan& plan, const TuneOutcome& outcome);

}  // namespace fulbito
