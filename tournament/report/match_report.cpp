#include "tournament/report/match_report.hpp"

#include <cmath>

#include <fmt/format.h>

#include "fulbito/statistics.hpp"
#include "match/report/speed_line.hpp"
#include "tournament/report/sections.hpp"

namespace fulbito {
namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;

constexpr int kSeriesLabel = 20;
constexpr int kTestLabel = 23;

std::string countedText(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string seriesVerdict(const TournamentState& state, const MatchFigures& figures) {
  if (figures.fixtures.empty()) return "no pair was finished";
  if (const auto better = betterTeam(figures)) return shownName(state, *better) + " is better (95 %)";
  return "no significant difference (95 %)";
}

std::string goalDifferenceText(const Interval& difference) {
  return fmt::format("{:+.2f} per match  ", difference.value) +
         (std::isfinite(difference.low)
              ? fmt::format("({:+.2f} ... {:+.2f}, 95 %)", difference.low, difference.high)
              : "(no interval from one pair)");
}

std::string numbers(double first, double second, int digits) {
  return fmt::format("{:.{}f} : {:.{}f}", first, digits, second, digits);
}

std::string shares(double first, double second) { return numbers(100 * first, 100 * second, 1) + " %"; }

Lines playLines(const PlayMeans& play) {
  const TeamMeans &a = play.teams[0], &b = play.teams[1];
  return {{"goal rate", numbers(a.goal_rate, b.goal_rate, 2) + " per 10 min of play"},
          {"shots", fmt::format("{} per match, on goal {}", numbers(a.shots, b.shots, 1),
                                numbers(a.shots_on_goal, b.shots_on_goal, 1))},
          {"own goals", numbers(a.own_goals, b.own_goals, 2) + " per match"},
          {"ball", fmt::format("in own third {}, at a wall {:.1f} %, in a corner {:.1f} %",
                               shares(a.own_third, b.own_third), 100 * play.at_wall, 100 * play.in_corner)},
          {"slow robots",
           fmt::format("{}, without keeper {}", shares(a.slow, b.slow), shares(a.field_slow, b.field_slow))},
          {"nobody behind ball", fmt::format("{}, without keeper {}", shares(a.uncovered, b.uncovered),
                                             shares(a.field_uncovered, b.field_uncovered))},
          {"keeper away", shares(a.keeper_away, b.keeper_away)},
          {"locks", fmt::format("{} per match", numbers(a.locks, b.locks, 2))},
          {"contacts", fmt::format("of teammates over {:g} s: {} per match, longest {} s", kLongContact,
                                   numbers(a.long_contacts, b.long_contacts, 1),
                                   numbers(a.longest_contact, b.longest_contact, 1))}};
}

Lines seriesLines(const TournamentState& state, const MatchFigures& figures) {
  const MeetingSummary& sums = figures.sums;
  const Interval& share = sums.points_share;
  Lines lines{{"matches", fmt::format("{}, {}, {} of {}", countedText(sums.won, "win", "wins"),
                                      countedText(sums.drawn, "draw", "draws"),
                                      countedText(sums.lost, "loss", "losses"), shownName(state, 0))},
              {"points share", fmt::format("{:.1f} %  ({:.1f} ... {:.1f} %, 95 %)", 100 * share.value,
                                           100 * share.low, 100 * share.high)},
              {"goal difference", goalDifferenceText(figures.goal_difference)},
              {"goals", fmt::format("{} : {}", sums.goals_for, sums.goals_against)},
              {"of these",
               fmt::format("{} : {} within {:g} s of the scoring team's own foul",
                           figures.goals_after_foul_for, figures.goals_after_foul_against, kFoulPaysWithin)},
              {"verdict", seriesVerdict(state, figures)}};
  const Lines play = playLines(figures.play);
  lines.insert(lines.end(), play.begin(), play.end());
  return lines;
}

Lines testLines(const TournamentState& state, const MatchFigures& figures) {
  const Sprt& sprt = *state.sprt;
  const auto& n = sprt.counts().counts;
  const MeetingSummary& sums = figures.sums;
  return {{"log-likelihood ratio", fmt::format("{:.2f}, pass at {:.2f}, fail at {:.2f}", sprt.ratio(),
                                               sprt.bounds().upper(), sprt.bounds().lower())},
          {"pairs", fmt::format("{}: LL {}, LD {}, LW+DD {}, DW {}, WW {}", sprt.counts().pairs(), n[0], n[1],
                                n[2], n[3], n[4])},
          {"matches", fmt::format("{} won, {} drawn, {} lost, goals {}:{}", sums.won, sums.drawn, sums.lost,
                                  sums.goals_for, sums.goals_against)},
          {"Elo (95 %)", eloText(sums.elo.elo)},
          {"normalized Elo (95 %)", eloText(sums.elo.normalized_elo)},
          {"superiority", fmt::format("{:.1f} %", 100 * sums.elo.superiority)}};
}

std::string seriesTitle(const TournamentState& state, const MatchFigures& figures) {
  const std::size_t pairs = figures.fixtures.size();
  return fmt::format("{} against {}: {} swapped pair{}, {} matches{}", shownName(state, 0),
                     shownName(state, 1), pairs, pairs == 1 ? "" : "s", 2 * pairs,
                     state.finished() ? "" : " (stopped early)");
}

std::string rulesLine(const TournamentPlan& plan) {
  return fmt::format("{}, halves of {:g} s, {} physics, seed {}", plan.match.rules.name,
                     plan.match.rules.half_seconds, plan.match.physics.name, plan.seed);
}

}  // namespace

std::string matchTitle(const TournamentState& state, const MatchFigures& figures) {
  if (!state.sprt) return seriesTitle(state, figures);
  return fmt::format("{} against {}: {}, {}", shownName(state, 0), shownName(state, 1),
                     nameOf(state.sprt->verdict()), meaningOf(state));
}

Lines matchLines(const TournamentState& state, const MatchFigures& figures) {
  return state.sprt ? testLines(state, figures) : seriesLines(state, figures);
}

std::string matchReportText(const TournamentState& state) {
  const MatchFigures figures = matchFigures(state);
  std::string text = matchTitle(state, figures) + '\n';
  if (!state.sprt) text += rulesLine(state.plan) + "\n\n";
  const int width = state.sprt ? kTestLabel : kSeriesLabel;
  for (const auto& [label, value] : matchLines(state, figures)) {
    text += fmt::format("  {:<{}}{}\n", label, width, value);
  }
  return state.sprt ? text : text + '\n' + speedLine(figures.simulated, 0.0);
}

}  // namespace fulbito
