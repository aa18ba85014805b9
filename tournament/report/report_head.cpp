#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "tournament/report/counted_results.hpp"
#include "tournament/report/sections.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

constexpr int kTitleColumns = 60;
constexpr int kNameColumns = 40;

std::string progressOf(const TournamentState& state) {
  const auto played = static_cast<std::size_t>(std::count_if(
      state.results.begin(), state.results.end(), [](const auto& pair) { return pair.has_value(); }));
  const std::size_t counted = countedFixtures(state).size();
  std::string text = fmt::format("{} of {} pairs{}, {} matches", played, state.schedule.fixtures.size(),
                                 state.schedule.complete ? "" : " known so far", 2 * played);
  if (counted < played) text += fmt::format("; the first {} pairs count", counted);
  return text;
}

std::string shownElo(double elo) {
  if (elo > kMostShownElo) return fmt::format(">{:+.0f}", kMostShownElo);
  if (elo < -kMostShownElo) return fmt::format("<{:+.0f}", -kMostShownElo);
  // Adding 0 turns -0 into +0, so that -0.3 does not print as -0.
  return fmt::format("{:+.0f}", std::round(elo) + 0.0);
}

bool goesBeyond(const TournamentTable& table) {
  for (std::size_t i = 0; i < table.totals.size(); ++i) {
    const Interval& elo = table.ratings.elo[i];
    if (table.totals[i].pairs > 0 && (elo.high > kMostShownElo || elo.low < -kMostShownElo)) return true;
  }
  return false;
}

std::vector<std::string> notesOf(const TournamentTable& table) {
  std::vector<std::string> notes;
  const auto& component = table.ratings.component;
  const auto last = std::max_element(component.begin(), component.end());
  if (last != component.end() && *last > 0) {
    notes.push_back(fmt::format(
        "Ratings compare within each of {} sets of teams that met each other, directly or not.", *last + 1));
  }
  if (table.ratings.prior) {
    notes.emplace_back(
        "A team, or a group of teams, won or lost everything: a prior keeps its rating finite.");
  }
  if (goesBeyond(table)) {
    notes.push_back(
        fmt::format("Elo beyond {:g} has no figure: where a team wins nearly all, single matches decide it.",
                    kMostShownElo));
  }
  return notes;
}

}  // namespace

ReportHead headOf(const TournamentState& state, const TournamentTable& table) {
  const TournamentPlan& plan = state.plan;
  ReportHead head;
  head.title = fmt::format("{}: {} of {} teams, {}", shownText(plan.name, kTitleColumns), nameOf(plan.format),
                           plan.entrants.size(), state.finished() ? "finished" : "so far");
  head.rules =
      fmt::format("{}, halves of {:g} s, {} physics, seed {}", shownText(plan.match.rules.name, kNameColumns),
                  plan.match.rules.half_seconds, shownText(plan.match.physics.name, kNameColumns), plan.seed);
  head.progress = progressOf(state);
  head.notes = notesOf(table);
  return head;
}

std::string shownName(const TournamentState& state, std::size_t entrant) {
  const std::string name = shownText(state.plan.entrants[entrant].name, kNameColumns);
  const bool blank = name.find_first_not_of(' ') == std::string::npos;
  return blank ? fmt::format("entrant {}", entrant + 1) : name;
}

std::string eloText(const Interval& interval) {
  if (!std::isfinite(interval.value) && !std::isfinite(interval.low) && !std::isfinite(interval.high))
    return "-";
  const bool beyond = interval.low > kMostShownElo || interval.high < -kMostShownElo;
  if (beyond) return shownElo(interval.value);
  return fmt::format("{} ({} to {})", shownElo(interval.value), shownElo(interval.low),
                     shownElo(interval.high));
}

std::vector<std::size_t> ranking(const TournamentTable& table) {
  std::vector<std::size_t> order;
  order.reserve(table.standings.size());
  for (const Standing& standing : table.standings) order.push_back(standing.entrant);
  return order;
}

std::vector<StartKind> kindsOf(const TournamentState& state) { return state.plan.book.kinds; }

std::string nameOfRound(int round, std::size_t entrants) {
  const int rounds = static_cast<int>(std::bit_width(entrants > 0 ? entrants - 1 : 0));
  switch (rounds - round) {
    case 1:
      return "final";
    case 2:
      return "semi-final";
    case 3:
      return "quarter-final";
    default:
      return rounds > round ? fmt::format("round of {}", 1 << (rounds - round))
                            : fmt::format("round {}", round + 1);
  }
}

std::string resultOf(const KnockOutTie& tie) {
  if (!tie.a || !tie.b || tie.points_a + tie.points_b == 0.0) return "-";
  return fmt::format("{:g} : {:g}, goals {}:{}", tie.points_a, tie.points_b, tie.goals_a, tie.goals_b);
}

}  // namespace fulbito
