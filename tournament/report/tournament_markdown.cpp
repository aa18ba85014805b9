#include <fmt/format.h>

#include "tournament/report/match_report.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"

namespace fulbito {
namespace {

/// A CI summary may have 1 MiB, for at most nine tables; the standings of all groups count as one.
constexpr std::size_t kBytesPerTable = 96 * 1024;
constexpr std::size_t kMostCrossed = 20;

std::string headMarkdown(const TournamentState& state, const TournamentTable& table) {
  const ReportHead head = headOf(state, table);
  std::string text = fmt::format("<!-- Fulbito -->\n\n## {}\n\n{}  \n{}\n\n", escapedMarkdown(head.title),
                                 escapedMarkdown(head.rules), escapedMarkdown(head.progress));
  for (const std::string& note : head.notes) text += escapedMarkdown(note) + "\n\n";
  return text;
}

Grid matchGrid(const TournamentState& state) {
  const MatchFigures figures = matchFigures(state);
  Grid grid{matchTitle(state, figures), {{"figure"}, {"value"}}, {}, {}};
  for (const auto& [label, value] : matchLines(state, figures)) {
    grid.rows.push_back({{label, std::nullopt, {}, {}}, {value, std::nullopt, {}, {}}});
  }
  return grid;
}

/// The standings, with one table per group, together within the size of one table.
std::string standingsMarkdown(const TournamentState& state, const TournamentTable& table) {
  std::string text;
  const std::vector<Grid> grids = standingGrids(state, table);
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const std::string next = markdownOf(grids[i], kBytesPerTable);
    if (text.size() + next.size() > kBytesPerTable) {
      return text + fmt::format("{} more groups do not fit here.\n\n", grids.size() - i);
    }
    text += next;
  }
  return text;
}

}  // namespace

std::string tournamentMarkdown(const TournamentState& state, const TournamentTable& table) {
  std::string text = headMarkdown(state, table);
  if (state.plan.format == TournamentFormat::kMatch) text += markdownOf(matchGrid(state), kBytesPerTable);
  text += standingsMarkdown(state, table);
  for (const Grid& grid :
       {unplayedGrid(state), bracketGrid(state, table), crossGrid(state, table, kMostCrossed),
        startGrid(state, table), faultGrid(state, table), notableGrid(state, table)}) {
    if (!grid.rows.empty()) text += markdownOf(grid, kBytesPerTable);
  }
  return text;
}

}  // namespace fulbito
