#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tournament/statistics/elo.hpp"
#include "tournament/tune/tune_run.hpp"

namespace fulbito {

/// What a final match-up shows about its first team, at 95 %.
enum class Improvement : std::uint8_t {
  kShown,     ///< the whole interval is above 0
  kNotShown,  ///< 0 is in the interval
  kWorse      ///< the whole interval is below 0
};
/// "shown", "not shown", "worse".
std::string_view nameOf(Improvement improvement);
/// The judgement of a difference with its interval.
Improvement improvementOf(const Interval& difference);

/// What the tuned team wins against the opponent and the start does not: the mean difference of their points
/// per match over the same starts, with Student's interval. Empty without an opponent or its results.
std::optional<Interval> gainOf(const TuneOutcome& outcome);

/// The report for people: parameters, the tuned team's specification, final match-ups. Also of a tuning that
/// goes on.
std::string tuneText(const TunePlan& plan, const TuneOutcome& outcome);

/// The report as JSON (docs/results-format.md), with a line end. Equal tunings give equal bytes.
std::string tuneJson(const TunePlan& plan, const TuneOutcome& outcome);

}  // namespace fulbito
