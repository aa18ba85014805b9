#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tournament/report/table.hpp"

/// Reports of a tournament of format match: a series of pairs, or a sequential test.
namespace fulbito {

/// What such a report says.
struct MatchFigures {
  std::vector<std::size_t> fixtures;  ///< those that count; with a test, those before the first gap
  MeetingSummary sums;                ///< of the first team
  PairCounts counts;                  ///< pairs by the first team's points
  Interval goal_difference;           ///< of the first team, per match; interval: `meanInterval` over pairs
  int goals_after_foul_for = 0, goals_after_foul_against = 0;
  double simulated = 0.0;  ///< [s]
};
MatchFigures matchFigures(const TournamentState& state);

/// The better team of a series (0 or 1): the whole 95 % interval of the points share lies on its side of
/// 50 %. Empty: no difference is shown.
std::optional<std::size_t> betterTeam(const MatchFigures& figures);

/// What the verdict of a test means: "rather +0 than -50 normalized Elo".
std::string meaningOf(const TournamentState& state);

/// The first line of the report.
std::string matchTitle(const TournamentState& state, const MatchFigures& figures);
/// Names and values of the report's lines.
std::vector<std::pair<std::string, std::string>> matchLines(const TournamentState& state,
                                                            const MatchFigures& figures);

/// @{ The report as text, and as a JSON object with a line end (docs/results-format.md). Each
/// match of a series is in the JSON.
std::string matchReportText(const TournamentState& state);
std::string matchReportJson(const TournamentState& state);
/// @}

}  // namespace fulbito
