#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tournament/report/table.hpp"

/// Reports of a tournament of format match: a series of pairs, or a sequential test.
namespace fulbito {

/// Period [s] of play of a team's goal rate.
inline constexpr double kRatePeriod = 600.0;

/// How one team plays, as means over all matches of a report.
struct TeamMeans {
  double goals = 0.0, shots = 0.0, shots_on_goal = 0.0, own_goals = 0.0;  ///< per match
  double locks = 0.0, long_contacts = 0.0;                                ///< per match
  double longest_contact = 0.0;                                           ///< [s] of all matches
  double goal_rate = 0.0;                                                 ///< per `kRatePeriod`
  /// Shares of the time of play; others as in `TeamPlay`.
  double own_third = 0.0, uncovered = 0.0, field_uncovered = 0.0, slow = 0.0, field_slow = 0.0;
  double keeper_away = 0.0;
};

/// How both teams play, the first team first.
struct PlayMeans {
  double play = 0.0;                      ///< [s] play time of all matches
  double at_wall = 0.0, in_corner = 0.0;  ///< shares of play time
  PerTeam<TeamMeans> teams;
};

/// The figures of a match report.
struct MatchFigures {
  /// Fixtures that count; with a test, those before the first missing result.
  std::vector<std::size_t> fixtures;
  MeetingSummary sums;       ///< results of the first team
  PairCounts counts;         ///< pairs by the first team's points
  Interval goal_difference;  ///< of the first team, per match; interval: `meanInterval` over pairs
  int goals_after_foul_for = 0, goals_after_foul_against = 0;
  PlayMeans play;          ///< of all matches
  double simulated = 0.0;  ///< [s] total length of the matches
};
MatchFigures matchFigures(const TournamentState& state);

/// The better team of a series (0 or 1): the whole 95 % interval of its points share is above 50 %. Empty if
/// the interval contains 50 %.
std::optional<std::size_t> betterTeam(const MatchFigures& figures);

/// What the verdict of a test means: "rather +0 than -50 normalized Elo".
std::string meaningOf(const TournamentState& state);

/// The title of the report, which is its first line.
std::string matchTitle(const TournamentState& state, const MatchFigures& figures);
/// Names and values of the report's lines. Figures of both teams stand as "first : second".
std::vector<std::pair<std::string, std::string>> matchLines(const TournamentState& state,
                                                            const MatchFigures& figures);

/// @{ The report as text, and as a JSON object with a line end (docs/results-format.md). The JSON of a series
/// lists each match.
std::string matchReportText(const TournamentState& state);
std::string matchReportJson(const TournamentState& state);
/// @}

}  // namespace fulbito
