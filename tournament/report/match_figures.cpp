#include <cmath>

#include <fmt/format.h>

#include "fulbito/statistics.hpp"
#include "tournament/report/counted_results.hpp"
#include "tournament/report/match_report.hpp"

namespace fulbito {
namespace {

/// The fixtures that count. With a test, pairs after the first gap do not count: the test has not seen them.
std::vector<std::size_t> fixturesOf(const TournamentState& state) {
  std::vector<std::size_t> numbers = countedFixtures(state);
  if (state.sprt) {
    numbers.resize(std::min(numbers.size(), static_cast<std::size_t>(state.sprt->counts().pairs())));
  }
  return numbers;
}

double ratio(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

TeamMeans meansOf(const PlayRecord& sums, std::size_t team, int goals, std::size_t pairs, double dt) {
  const TeamRecord& record = sums.teams[team];
  const double matches = 2.0 * static_cast<double>(pairs);
  const auto per_match = [&](std::int64_t count) { return ratio(static_cast<double>(count), matches); };
  const auto ticks = static_cast<double>(sums.play_ticks);
  const auto share = [&](Tick part) { return ratio(static_cast<double>(part), ticks); };
  TeamMeans means;
  means.goals = per_match(goals);
  means.shots = per_match(record.shots);
  means.shots_on_goal = per_match(record.shots_on_goal);
  means.own_goals = per_match(record.own_goals);
  means.locks = per_match(record.locks);
  means.long_contacts = per_match(record.long_contacts);
  means.longest_contact = static_cast<double>(record.longest_contact) * dt;
  means.goal_rate = ratio(goals * kRatePeriod, ticks * dt);
  means.own_third = share(record.own_third);
  means.uncovered = share(record.uncovered);
  means.field_uncovered = share(record.field_uncovered);
  means.slow = record.slow();
  means.field_slow = record.fieldSlow();
  means.keeper_away = record.keeperAway();
  return means;
}

PlayMeans meansOf(const PlayRecord& sums, const MatchFigures& figures, double dt) {
  const auto ticks = static_cast<double>(sums.play_ticks);
  PlayMeans means;
  means.play = ticks * dt;
  means.at_wall = ratio(static_cast<double>(sums.wall_ticks), ticks);
  means.in_corner = ratio(static_cast<double>(sums.corner_ticks), ticks);
  const std::size_t pairs = figures.fixtures.size();
  means.teams[0] = meansOf(sums, 0, figures.sums.goals_for, pairs, dt);
  means.teams[1] = meansOf(sums, 1, figures.sums.goals_against, pairs, dt);
  return means;
}

void addFouls(MatchFigures& figures, const PairResult& pair) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    figures.goals_after_foul_for += pair.legs[leg].goals_after_foul[leg];
    figures.goals_after_foul_against += pair.legs[leg].goals_after_foul[1 - leg];
  }
}

}  // namespace

MatchFigures matchFigures(const TournamentState& state) {
  MatchFigures figures;
  figures.fixtures = fixturesOf(state);
  Tally tally;
  std::vector<double> differences;
  PlayRecord play;
  Tick ticks = 0;
  for (const std::size_t number : figures.fixtures) {
    const PairResult& pair = *state.results[number];
    tally.add(pair, true);
    figures.counts.add(pair.points());
    addFouls(figures, pair);
    for (std::size_t leg = 0; leg < 2; ++leg) play.add(pair.legs[leg].play, leg);
    differences.push_back((pair.goalsOfA() - pair.goalsOfB()) / 2.0);
    ticks += pair.legs[0].ticks + pair.legs[1].ticks;
  }
  figures.sums = tally.summary();
  figures.goal_difference = meanInterval(differences);
  const double dt = state.plan.match.physics.controlPeriod();
  figures.play = meansOf(play, figures, dt);
  figures.simulated = static_cast<double>(ticks) * dt;
  return figures;
}

std::optional<std::size_t> betterTeam(const MatchFigures& figures) {
  if (figures.fixtures.empty()) return std::nullopt;
  if (figures.sums.points_share.low > 0.5) return 0;
  if (figures.sums.points_share.high < 0.5) return 1;
  return std::nullopt;
}

std::string meaningOf(const TournamentState& state) {
  const SprtBounds& bounds = state.sprt->bounds();
  switch (state.sprt->verdict()) {
    case SprtVerdict::kPass:
      return fmt::format("rather {:+g} than {:+g} normalized Elo", bounds.strong, bounds.weak);
    case SprtVerdict::kFail:
      return fmt::format("rather {:+g} than {:+g} normalized Elo", bounds.weak, bounds.strong);
    case SprtVerdict::kInconclusive:
      break;
  }
  return state.finished() ? fmt::format("no verdict after {} pairs", state.sprt->counts().pairs())
                          : "stopped before a verdict";
}

}  // namespace fulbito
