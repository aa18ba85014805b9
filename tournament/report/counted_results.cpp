#include "tournament/report/counted_results.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace fulbito {
namespace {

/// Whether the team at `seat` lost by walk-over. An absent team has no faults, so the winner tells.
bool forfeited(const MatchResult& result, std::size_t seat) {
  if (result.outcome != MatchOutcome::kForfeit) return false;
  const auto& teams = result.faults.teams;
  if (teams[0].forfeited || teams[1].forfeited) return teams[seat].forfeited;
  return result.winner != kTeams[seat];
}

}  // namespace

std::vector<std::size_t> countedFixtures(const TournamentState& state) {
  std::vector<std::size_t> numbers;
  const std::size_t end = std::min({state.counted, state.results.size(), state.schedule.fixtures.size()});
  for (std::size_t i = 0; i < end; ++i) {
    if (state.results[i]) numbers.push_back(i);
  }
  return numbers;
}

MatchId idOf(const TournamentState& state, std::size_t fixture, std::size_t leg) {
  return fixture < state.ids.size() ? state.ids[fixture][leg] : MatchId{};
}

std::string numberOf(std::size_t fixture, std::size_t leg) {
  return fmt::format("{}.{}", fixture + 1, leg + 1);
}

MatchOutcome outcomeOfSeat(const MatchResult& result, std::size_t seat) {
  const TeamFaults& faults = result.faults.teams[seat];
  if (forfeited(result, seat)) return MatchOutcome::kForfeit;
  if (faults.failures > 0) return MatchOutcome::kCrash;
  if (faults.not_finite + faults.no_navigator > 0) return MatchOutcome::kIllegal;
  if (faults.late > 0) return MatchOutcome::kSlow;
  const bool lost = result.winner && *result.winner != kTeams[seat];
  return lost && result.outcome == MatchOutcome::kMercy ? MatchOutcome::kMercy : MatchOutcome::kNormal;
}

void Tally::add(const PairResult& pair, bool as_a) {
  const double points = as_a ? pair.points() : 1.0 - pair.points();
  counts_.add(points);
  points_.push_back(points);
  sums_.goals_for += as_a ? pair.goalsOfA() : pair.goalsOfB();
  sums_.goals_against += as_a ? pair.goalsOfB() : pair.goalsOfA();
  for (std::size_t leg = 0; leg < 2; ++leg) {
    const auto& winner = pair.legs[leg].winner;
    const TeamId mine = kTeams[as_a ? leg : 1 - leg];
    ++(!winner ? sums_.drawn : *winner == mine ? sums_.won : sums_.lost);
  }
}

MeetingSummary Tally::summary() const {
  MeetingSummary summary = sums_;
  summary.pairs = static_cast<int>(points_.size());
  summary.points_share = shareInterval(points_);
  summary.elo = estimateElo(counts_);
  return summary;
}

}  // namespace fulbito
