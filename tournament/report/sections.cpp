#include "tournament/report/sections.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tournament/formats/format.hpp"
#include "tournament/report/counted_results.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

GridCell cell(std::string text) { return {std::move(text), std::nullopt, {}, {}}; }
GridCell number(int value) { return cell(fmt::format("{}", value)); }

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

/// The points share of a meeting, coloured; the hint lists all its results.
GridCell shareCell(const MeetingSummary& meeting, const std::string& text) {
  if (meeting.pairs == 0) return cell({});
  return {text,
          meeting.points_share.value,
          fmt::format("{} won, {} drawn, {} lost, goals {}:{}, {:.0f} to {:.0f} %", meeting.won,
                      meeting.drawn, meeting.lost, meeting.goals_for, meeting.goals_against,
                      100 * meeting.points_share.low, 100 * meeting.points_share.high),
          {}};
}

int faultsOf(const FaultSummary& faults) {
  return faults.of(MatchOutcome::kForfeit) + faults.of(MatchOutcome::kCrash) +
         faults.of(MatchOutcome::kIllegal) + faults.of(MatchOutcome::kSlow);
}

/// Which optional columns the standings of this tournament need.
struct StandingColumns {
  bool pair_points = false, byes = false, faults = false, ties = false;
};

StandingColumns columnsFor(const TournamentState& state, const TournamentTable& table) {
  StandingColumns show;
  show.pair_points = formatOf(state.plan).counts_pair_points;
  for (const Standing& s : table.standings) {
    show.byes |= s.byes > 0;
    show.ties |= !s.decided_by.empty();
    show.faults |= faultsOf(table.faults[s.entrant]) > 0;
  }
  return show;
}

std::vector<GridColumn> standingColumns(const StandingColumns& show) {
  std::vector<GridColumn> columns{{"#", true}, {"team", false, true}, {"matches", true}};
  for (const char* name : {"won", "drawn", "lost", "goals"}) columns.push_back({name, true});
  columns.push_back({"+/-", true, false, true});
  columns.push_back({"points", true});
  if (show.pair_points) columns.push_back({"pair points", true});
  columns.push_back({"share", true});
  columns.push_back({"Elo (95 %)", true});
  if (show.faults) columns.push_back({"faults", true});
  if (show.byes) columns.push_back({"byes", true, false, true});
  if (show.ties) columns.push_back({"tie-break", false, true, true});
  return columns;
}

std::vector<GridCell> standingRow(const TournamentState& state, const TournamentTable& table,
                                  const Standing& s, const StandingColumns& show) {
  std::vector<GridCell> row{number(s.rank),    cell(shownName(state, s.entrant)),
                            number(s.matches), number(s.won),
                            number(s.drawn),   number(s.lost)};
  row.push_back(cell(fmt::format("{}:{}", s.goals_for, s.goals_against)));
  const int difference = s.goals_for - s.goals_against;
  row.push_back(cell(difference == 0 ? "0" : fmt::format("{:+}", difference)));
  row.push_back(number(s.points));
  if (show.pair_points) row.push_back(cell(fmt::format("{:g}", s.pair_points)));
  const MeetingSummary& total = table.totals[s.entrant];
  row.push_back(shareCell(total, percent(total.points_share.value)));
  row.push_back(cell(total.pairs > 0 ? eloText(table.ratings.elo[s.entrant]) : "-"));
  if (show.faults) row.push_back(number(faultsOf(table.faults[s.entrant])));
  if (show.byes) row.push_back(number(s.byes));
  if (show.ties) row.push_back(cell(shownText(s.decided_by, kTextColumns)));
  return row;
}

std::string nameOfEntrant(const TournamentState& state, const std::optional<std::size_t>& entrant,
                          const char* otherwise) {
  return entrant ? shownName(state, *entrant) : otherwise;
}

}  // namespace

std::vector<Grid> standingGrids(const TournamentState& state, const TournamentTable& table) {
  const StandingColumns show = columnsFor(state, table);
  std::vector<Grid> grids;
  for (int group = 0; group < std::max(1, state.plan.groups); ++group) {
    Grid grid{"Standings", standingColumns(show), {}, {}};
    if (state.plan.groups > 1) grid.title += fmt::format(", group {}", group + 1);
    for (const Standing& s : table.standings) {
      if (s.group == group) grid.rows.push_back(standingRow(state, table, s, show));
    }
    if (!grid.rows.empty()) grids.push_back(std::move(grid));
  }
  return grids;
}

Grid bracketGrid(const TournamentState& state, const TournamentTable& table) {
  Grid grid{"Bracket",
            {{"round"},
             {"team", false, true},
             {"team", false, true},
             {"points"},
             {"winner", false, true},
             {"decided by", false, true, true}},
            {},
            {}};
  for (const KnockOutTie& tie : table.bracket) {
    const char* open = tie.decided_by == "bye" ? "bye" : "?";
    grid.rows.push_back(
        {cell(tie.third_place ? "third place" : nameOfRound(tie.round, state.plan.entrants.size())),
         cell(nameOfEntrant(state, tie.a, open)), cell(nameOfEntrant(state, tie.b, open)),
         cell(resultOf(tie)), cell(nameOfEntrant(state, tie.winner, "?")),
         cell(shownText(tie.decided_by, kTextColumns))});
  }
  return grid;
}

Grid crossGrid(const TournamentState& state, const TournamentTable& table, std::size_t most) {
  std::vector<std::size_t> order = ranking(table);
  Grid grid{"Cross-table: points share [%] of the row's team", {{"#", true}, {"team", false, true}}, {}, {}};
  if (order.size() > most) {
    grid.note = fmt::format("The {} best of {} teams.", most, order.size());
    order.resize(most);
  }
  if (order.size() < 2) return grid;
  for (std::size_t i = 0; i < order.size(); ++i) grid.columns.push_back({fmt::format("{}", i + 1), true});
  for (std::size_t i = 0; i < order.size(); ++i) {
    grid.rows.push_back({number(static_cast<int>(i + 1)), cell(shownName(state, order[i]))});
    for (const std::size_t column : order) {
      const MeetingSummary& meeting = table.cross[order[i]][column];
      GridCell share = shareCell(meeting, fmt::format("{:.0f}", 100 * meeting.points_share.value));
      if (column == order[i]) share.text = "-";
      grid.rows.back().push_back(std::move(share));
    }
  }
  return grid;
}

Grid startGrid(const TournamentState& state, const TournamentTable& table) {
  Grid grid{"Points share [%] by kind of start, with 95 % interval", {{"team", false, true}}, {}, {}};
  const std::vector<StartKind> kinds = kindsOf(state);
  if (kinds.size() < 2) return grid;
  for (const StartKind kind : kinds) grid.columns.push_back({std::string(nameOf(kind)), true});
  for (const std::size_t entrant : ranking(table)) {
    grid.rows.push_back({cell(shownName(state, entrant))});
    for (const StartKind kind : kinds) {
      const MeetingSummary& meeting = table.starts[entrant][static_cast<std::size_t>(kind)];
      const Interval& share = meeting.points_share;
      grid.rows.back().push_back(shareCell(
          meeting,
          fmt::format("{:.0f} ({:.0f} to {:.0f})", 100 * share.value, 100 * share.low, 100 * share.high)));
    }
  }
  return grid;
}

Grid faultGrid(const TournamentState& state, const TournamentTable& table) {
  constexpr MatchOutcome kShown[] = {MatchOutcome::kForfeit, MatchOutcome::kCrash, MatchOutcome::kIllegal,
                                     MatchOutcome::kSlow, MatchOutcome::kMercy};
  Grid grid{"Matches with faults", {{"team", false, true}}, {}, {}};
  for (const MatchOutcome outcome : kShown) grid.columns.push_back({std::string(nameOf(outcome)), true});
  grid.columns.push_back({"last failure", false, true});
  for (const std::size_t entrant : ranking(table)) {
    const FaultSummary& faults = table.faults[entrant];
    if (faultsOf(faults) + faults.of(MatchOutcome::kMercy) == 0) continue;
    grid.rows.push_back({cell(shownName(state, entrant))});
    for (const MatchOutcome outcome : kShown) grid.rows.back().push_back(number(faults.of(outcome)));
    grid.rows.back().push_back(cell(shownText(faults.last_failure, kTextColumns)));
  }
  return grid;
}

Grid notableGrid(const TournamentState& state, const TournamentTable& table) {
  Grid grid{
      "Matches to look at", {{"match", true}, {"what", false, true}, {"start"}, {"seed", true}}, {}, {}};
  for (const NotableMatch& match : table.notable) {
    const PairResult& pair = *state.results[match.fixture];
    const Fixture& fixture = state.schedule.fixtures[match.fixture];
    grid.rows.push_back({{numberOf(match.fixture, match.leg), std::nullopt, {}, match.id.text()},
                         cell(shownText(match.why, 2 * kTextColumns)),
                         cell(bookEntry(state.plan.book, fixture.start).name),
                         cell(fmt::format("{}", pair.seed))});
  }
  if (!table.recorded) {
    grid.note = "To watch them: fulbito tournament report FOLDER --recordings upsets --html FILE";
  }
  return grid;
}

Grid unplayedGrid(const TournamentState& state) {
  constexpr std::size_t kMostShown = 20;
  Grid grid{"Matches not played, as the machine failed",
            {{"match", true}, {"blue", false, true}, {"yellow", false, true}, {"reason", false, true}},
            {},
            {}};
  for (const UnplayedMatch& match : state.unplayed) {
    if (grid.rows.size() == kMostShown) break;
    const Fixture& fixture = state.schedule.fixtures[match.fixture];
    grid.rows.push_back({cell(numberOf(match.fixture, match.leg)),
                         cell(shownName(state, entrantAt(fixture, match.leg, 0))),
                         cell(shownName(state, entrantAt(fixture, match.leg, 1))),
                         cell(shownText(match.reason, 2 * kTextColumns))});
  }
  if (state.unplayed.size() > kMostShown) {
    grid.note = fmt::format("{} more were not played.", state.unplayed.size() - kMostShown);
  }
  return grid;
}

}  // namespace fulbito
