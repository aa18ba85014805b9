#include <algorithm>

#include "tournament/formats/circle.hpp"
#include "tournament/formats/fixed_formats.hpp"

namespace fulbito {
namespace {

/// Rounds in which each of `entrants` meets each other once: with an odd number one rests per round.
std::size_t roundsPerCycle(std::size_t entrants) { return entrants + entrants % 2 - 1; }

/// All fixtures of one start, rounds from 0.
std::vector<Fixture> cycleOf(const std::vector<std::vector<std::size_t>>& groups, std::size_t rounds) {
  std::vector<Fixture> cycle;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const auto& group : groups) {
      if (round >= roundsPerCycle(group.size())) continue;
      for (const auto& [a, b] : circleRound(group.size() + group.size() % 2, round)) {
        if (b < group.size()) cycle.push_back({group[a], group[b], static_cast<int>(round), 0});
      }
    }
  }
  return cycle;
}

}  // namespace

std::vector<std::vector<std::size_t>> groupsOf(const TournamentPlan& plan) {
  const auto count = static_cast<std::size_t>(plan.groups);
  std::vector<std::vector<std::size_t>> groups(count);
  for (std::size_t i = 0; i < plan.entrants.size(); ++i) {
    const std::size_t place = i % count;
    groups[i / count % 2 == 0 ? place : count - 1 - place].push_back(i);
  }
  return groups;
}

Schedule roundRobinSchedule(const TournamentPlan& plan) {
  const auto groups = groupsOf(plan);
  std::size_t rounds = 0;
  for (const auto& group : groups) rounds = std::max(rounds, roundsPerCycle(group.size()));
  const std::vector<Fixture> cycle = cycleOf(groups, rounds);
  Schedule schedule;
  schedule.complete = true;
  schedule.fixtures.reserve(cycle.size() * static_cast<std::size_t>(plan.pairs));
  for (int start = 0; start < plan.pairs; ++start) {
    for (Fixture fixture : cycle) {
      fixture.start = static_cast<std::size_t>(start);
      fixture.round += start * static_cast<int>(rounds);
      schedule.fixtures.push_back(fixture);
    }
  }
  return schedule;
}

}  // namespace fulbito
