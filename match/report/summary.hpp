#pragma once

#include <optional>
#include <string>

#include "match/play/match.hpp"
#include "match/report/event_lines.hpp"
#include "match/report/statistics.hpp"
#include "match/series/series.hpp"

namespace fulbito {

/// A match that was played, or broken off, with all that its summary tells.
struct MatchReport {
  MatchConfig config;
  RefereeState referee;  ///< at the end
  bool complete = true;  ///< false: broken off before its end
  int edits = 0;         ///< how often a user placed ball and robots anew
  MatchStatistics statistics;
  std::vector<LoggedEvent> events;
  std::size_t events_left_out = 0;
  MatchFaults faults;
  std::uint64_t final_hash = 0;
  double simulated = 0.0;               ///< [s]
  double wall = 0.0;                    ///< [s] that it took
  std::optional<MatchProfile> profile;  ///< where the time went, if it was measured
};

/// What is known of a match now.
MatchReport reportOf(const Match& match, const StatisticsObserver& statistics, const EventLog& events);

/// A summary to be read: score, goals, and a table with a column a team.
std::string matchText(const MatchReport& report);
/// One JSON object (docs/results-format.md), with a line end. Measured times stand under keys that begin with
/// `compute_` or `wall_`, and under `x_realtime`; all else is the same bytes for the same match.
std::string matchJson(const MatchReport& report);
/// How fast it went, to two digits at least: "0.25 x real time". Empty if the wall time [s] is not known.
std::string paceText(double simulated, double wall);
/// Shares of the wall time, a line each.
std::string profileText(const MatchProfile& profile);

/// A series that was played, or broken off.
struct SeriesReport {
  SeriesConfig config;
  SeriesResult result;
  double wall = 0.0;  ///< [s] that it took

  double simulated() const;  ///< [s] of all matches
};

/// The team that a series shows to be better, 0: A, 1: B: the one on whose side of 50 % the whole 95 %
/// interval of the points share lies. Empty: no difference is shown.
std::optional<std::size_t> betterTeam(const SeriesResult& result);

/// @{ As for a match. Intervals that need more pairs than there are say so (JSON: null).
std::string seriesText(const SeriesReport& report);
std::string seriesJson(const SeriesReport& report);
/// @}

}  // namespace fulbito
