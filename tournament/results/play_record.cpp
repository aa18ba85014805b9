#include "tournament/results/play_record.hpp"

#include <algorithm>

namespace fulbito {
namespace {

void addTo(TeamRecord& sums, const TeamRecord& match) {
  const Tick longest = std::max(sums.longest_contact, match.longest_contact);
  for (const auto count : kPlayCounts) sums.*count += match.*count;
  sums.longest_contact = longest;
}

}  // namespace

void PlayRecord::add(const PlayRecord& match, std::size_t first) {
  play_ticks += match.play_ticks;
  wall_ticks += match.wall_ticks;
  corner_ticks += match.corner_ticks;
  addTo(teams[0], match.teams[first]);
  addTo(teams[1], match.teams[1 - first]);
}

PlayRecord recordOf(const MatchStatistics& statistics) {
  PlayRecord record{statistics.play_ticks, statistics.wall_ticks, statistics.corner_ticks, {}};
  for (std::size_t i = 0; i < kTeams.size(); ++i) {
    const TeamStatistics& team = statistics.teams[i];
    record.teams[i] = {team.play, team.shots, team.shots_on_goal, team.own_goals, team.thirds[0]};
  }
  return record;
}

}  // namespace fulbito
