#include <iterator>

#include <fmt/format.h>

#include "engine/core/base/text_controls.hpp"
#include "match/report/match_json.hpp"
#include "tournament/report/counted_results.hpp"
#include "tournament/report/report.hpp"

namespace fulbito {
namespace {

constexpr const char* kHeading =
    "pair,leg,counts,round,id,blue,yellow,start,seed,goals_blue,goals_yellow,winner,outcome,fault_blue,"
    "fault_yellow,goals_after_foul_blue,goals_after_foul_yellow,simulated_s,abandoned,final_hash\n";

void addLine(std::string& text, const TournamentState& state, const std::vector<std::string>& names,
             std::size_t number, std::size_t leg) {
  const Fixture& fixture = state.schedule.fixtures[number];
  const PairResult& pair = *state.results[number];
  const MatchResult& r = pair.legs[leg];
  fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                 number, leg + 1, number < state.counted ? "true" : "false", fixture.round,
                 idOf(state, number, leg).text(), names[entrantAt(fixture, leg, 0)],
                 names[entrantAt(fixture, leg, 1)], bookEntry(state.plan.book, fixture.start).name, pair.seed,
                 r.score[0], r.score[1], r.winner ? nameOf(*r.winner) : "", nameOf(r.outcome),
                 nameOf(outcomeOfSeat(r, 0)), nameOf(outcomeOfSeat(r, 1)), r.goals_after_foul[0],
                 r.goals_after_foul[1],
                 static_cast<double>(r.ticks) * state.plan.match.physics.controlPeriod(),
                 r.faults.abandoned ? "true" : "false", hashText(r.hash));
}

}  // namespace

std::string tournamentCsv(const TournamentState& state) {
  std::vector<std::string> names;
  names.reserve(state.plan.entrants.size());
  for (const Entrant& entrant : state.plan.entrants) names.push_back(csvField(entrant.name));
  std::string text = kHeading;
  for (std::size_t i = 0; i < std::min(state.results.size(), state.schedule.fixtures.size()); ++i) {
    if (!state.results[i]) continue;
    for (std::size_t leg = 0; leg < 2; ++leg) addLine(text, state, names, i, leg);
  }
  return text;
}

}  // namespace fulbito
