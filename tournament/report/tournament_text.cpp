#include <fmt/format.h>

#include "tournament/report/match_report.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostCrossed = 12;

void append(std::string& text, const Grid& grid) {
  if (!grid.rows.empty()) text += '\n' + textOf(grid);
}

std::string headText(const TournamentState& state, const TournamentTable& table) {
  const ReportHead head = headOf(state, table);
  std::string text = fmt::format("{}\n  {}\n  {}\n", head.title, head.rules, head.progress);
  for (const std::string& note : head.notes) text += fmt::format("  {}\n", note);
  return text;
}

std::string tablesText(const TournamentState& state, const TournamentTable& table) {
  std::string text = headText(state, table);
  for (const Grid& grid : standingGrids(state, table)) append(text, grid);
  append(text, bracketGrid(state, table));
  if (table.standings.size() <= kMostCrossed && state.plan.groups <= 1) {
    append(text, crossGrid(state, table, kMostCrossed));
  }
  return text;
}

}  // namespace

std::string tournamentText(const TournamentState& state, const TournamentTable& table) {
  const bool match = state.plan.format == TournamentFormat::kMatch;
  std::string text = match ? matchReportText(state) : tablesText(state, table);
  append(text, unplayedGrid(state));
  append(text, startGrid(state, table));
  append(text, faultGrid(state, table));
  // The report of a series or test has only a few lines; a list of single matches would hide them.
  if (!match) append(text, notableGrid(state, table));
  return text;
}

}  // namespace fulbito
