#pragma once

#include <string>
#include <vector>

#include "tournament/report/grid.hpp"
#include "tournament/report/table.hpp"

/// The parts of a report for people, whatever it is written in.
namespace fulbito {

/// What stands above the tables.
struct ReportHead {
  std::string title;               ///< "cup: round-robin of 12 teams, finished"
  std::string rules;               ///< "vsss-3v3, halves of 300 s, standard physics, seed 1"
  std::string progress;            ///< "132 of 132 pairs, 264 matches"
  std::vector<std::string> notes;  ///< sentences about the ratings
};
ReportHead headOf(const TournamentState& state, const TournamentTable& table);

/// A team's name in a table; its number from 1 if nothing of the name can be shown.
std::string shownName(const TournamentState& state, std::size_t entrant);
/// Figures beyond this [Elo] are shown as such. Without draws they mean that the weaker side gets less than 1
/// of 57 points, so a single lost match decides how far beyond. A series of any length has such a limit; this
/// one belongs to those of about a hundred matches.
inline constexpr double kMostShownElo = 700.0;
/// "+210 (+180 to +240)", ">+700 (+650 to >+700)", ">+700" if the interval lies beyond, too; "-" without a
/// match.
std::string eloText(const Interval& interval);
/// Entrants, best first.
std::vector<std::size_t> ranking(const TournamentTable& table);
/// Kinds of starts that the book has, in its order.
std::vector<StartKind> kindsOf(const TournamentState& state);
/// "final", "semi-final", "quarter-final", "round of 16" for a round from 0 of a knock-out.
std::string nameOfRound(int round, std::size_t entrants);
/// "1.5 : 0.5, goals 4:2"; "-" for a bye or a tie that was not played.
std::string resultOf(const KnockOutTie& tie);

/// @{ Tables. One without rows has nothing to show.
/// A table per group.
std::vector<Grid> standingGrids(const TournamentState& state, const TournamentTable& table);
/// Ties of a knock-out by round.
Grid bracketGrid(const TournamentState& state, const TournamentTable& table);
/// Points shares of the row's team against the column's, of the `most` best teams.
Grid crossGrid(const TournamentState& state, const TournamentTable& table, std::size_t most);
/// Points shares by kind of start; nothing if the book has one kind.
Grid startGrid(const TournamentState& state, const TournamentTable& table);
/// Teams with faults.
Grid faultGrid(const TournamentState& state, const TournamentTable& table);
Grid notableGrid(const TournamentState& state, const TournamentTable& table);
/// Matches that the machine failed.
Grid unplayedGrid(const TournamentState& state);
/// @}

}  // namespace fulbito
