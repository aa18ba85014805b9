#pragma once

#include <optional>
#include <string>

#include "match/play/match.hpp"
#include "match/report/event_lines.hpp"
#include "match/report/statistics.hpp"
#include "match/series/series.hpp"

namespace fulbito {

/// A finished or stopped match with everything that its summary needs.
struct MatchReport {
  MatchConfig config;
  RefereeState referee;  ///< at the end
  bool complete = true;  ///< false: stopped before its end
  int edits = 0;         ///< how often a user moved the ball or robots
  MatchStatistics statistics;
  std::vector<LoggedEvent> events;
  std::size_t events_left_out = 0;
  MatchFaults faults;
  std::uint64_t final_hash = 0;
  double simulated = 0.0;               ///< [s]
  double wall = 0.0;                    ///< [s] wall time
  std::optional<MatchProfile> profile;  ///< time per stage, if measured
};

/// The report on a match as it stands now.
MatchReport reportOf(const Match& match, const StatisticsObserver& statistics, const EventLog& events);

/// A summary for people: score, goals, and a table with one column per team.
std::string matchText(const MatchReport& report);
/// One JSON object (docs/results-format.md), with a line end. Measured times have keys that begin with
/// `compute_` or `wall_`, or `x_realtime`; everything else is byte-identical for the same match.
std::string matchJson(const MatchReport& report);
/// The simulation speed with at least two digits: "0.25 x real time". Empty if `wall` [s] is not positive.
std::string paceText(double simulated, double wall);
/// Shares of the wall time, one line per stage.
std::string profileText(const MatchProfile& profile);

/// A finished or stopped series.
struct SeriesReport {
  SeriesConfig config;
  SeriesResult result;
  double wall = 0.0;  ///< [s] wall time

  double simulated() const;  ///< [s] of all matches
};

/// The team that is significantly better, 0: A, 1: B: the whole 95 % interval of the points share lies on its
/// side of 50 %. Empty: no significant difference.
std::optional<std::size_t> betterTeam(const SeriesResult& result);

/// @{ As for a match. With too few pairs for an interval, the text says so and the JSON has null.
std::string seriesText(const SeriesReport& report);
std::string seriesJson(const SeriesReport& report);
/// @}

}  // namespace fulbito
