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
  Tick ticks = 0;
  for (const std::size_t number : figures.fixtures) {
    const PairResult& pair = *state.results[number];
    tally.add(pair, true);
    figures.counts.add(pair.points());
    addFouls(figures, pair);
    differences.push_back((pair.goalsOfA() - pair.goalsOfB()) / 2.0);
    ticks += pair.legs[0].ticks + pair.legs[1].ticks;
  }
  figures.sums = tally.summary();
  figures.goal_difference = meanInterval(differences);
  figures.simulated = static_cast<double>(ticks) * state.plan.match.physics.controlPeriod();
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
