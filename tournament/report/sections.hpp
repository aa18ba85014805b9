#pragma once

#include <string>
#include <vector>

#include "tournament/report/grid.hpp"
#include "tournament/report/table.hpp"

/// Parts of the reports for people, independent of the output format.
namespace fulbito {

/// The lines above the tables of a report.
struct ReportHead {
  std::string title;               ///< "cup: round-robin of 12 teams, finished"
  std::string rules;               ///< "vsss-3v3, halves of 300 s, standard physics, seed 1"
  std::string progress;            ///< "132 of 132 pairs, 264 matches"
  std::vector<std::string> notes;  ///< sentences about the ratings
};
ReportHead headOf(const TournamentState& state, const TournamentTable& table);

/// A team's name in a table, or its number from 1 if the name has no printable character.
std::string shownName(const TournamentState& state, std::size_t entrant);
/// Larger Elo figures are shown as beyond this limit [Elo]. At this lead without draws, the weaker side gets
/// less than 1 of 57 points, so a single lost match changes the estimate widely. The value suits series of
/// about a hundred matches.
inline constexpr double kMostShownElo = 700.0;
/// "+210 (+180 to +240)", ">+700 (+650 to >+700)"; ">+700" if the whole interval lies beyond the limit; "-"
/// without a match.
std::string eloText(const Interval& interval);
/// All entrants, the best first.
std::vector<std::size_t> ranking(const TournamentTable& table);
/// The kinds of starts in the book, in its order.
std::vector<StartKind> kindsOf(const TournamentState& state);
/// The name of a knock-out round (from 0): "final", "semi-final", "quarter-final", "round of 16".
std::string nameOfRound(int round, std::size_t entrants);
/// The result of a tie: "1.5 : 0.5, goals 4:2"; "-" for a bye or a tie that was not played.
std::string resultOf(const KnockOutTie& tie);

/// @{ Tables. A table without rows has nothing to show and is left out.
/// One table per group.
std::vector<Grid> standingGrids(const TournamentState& state, const TournamentTable& table);
/// The ties of a knock-out by round.
Grid bracketGrid(const TournamentState& state, const TournamentTable& table);
/// Points share of each row's team against each column's team, for the `most` best teams.
Grid crossGrid(const TournamentState& state, const TournamentTable& table, std::size_t most);
/// Points share of each team by kind of start; without rows if the book has only one kind.
Grid startGrid(const TournamentState& state, const TournamentTable& table);
/// Teams with faults, and how many of each kind.
Grid faultGrid(const TournamentState& state, const TournamentTable& table);
Grid notableGrid(const TournamentState& state, const TournamentTable& table);
/// Matches left out because the machine failed.
Grid unplayedGrid(const TournamentState& state);
/// @}

}  // namespace fulbito
