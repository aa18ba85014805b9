#pragma once

#include <cstdint>

#include "fulbito/statistics.hpp"

namespace fulbito {

/// What a result keeps of a team's statistics.
struct TeamRecord : TeamPlay {
  std::int64_t shots = 0, shots_on_goal = 0, own_goals = 0;
  Tick own_third = 0;  ///< ticks with the ball in its own third
};

/// All counts of a `TeamRecord`, in the order of files.
inline constexpr std::int64_t TeamRecord::* kPlayCounts[] = {
    &TeamRecord::shots,      &TeamRecord::shots_on_goal,   &TeamRecord::own_goals,
    &TeamRecord::own_third,  &TeamRecord::own_half,        &TeamRecord::keeper_away,
    &TeamRecord::uncovered,  &TeamRecord::field_uncovered, &TeamRecord::robot_ticks,
    &TeamRecord::slow_ticks, &TeamRecord::field_ticks,     &TeamRecord::field_slow_ticks,
    &TeamRecord::locks,      &TeamRecord::long_contacts,   &TeamRecord::longest_contact};

/// What a result keeps of a match's statistics, or of those of several matches.
struct PlayRecord {
  Tick play_ticks = 0, wall_ticks = 0, corner_ticks = 0;  ///< as in `MatchStatistics`
  PerTeam<TeamRecord> teams;

  /// Adds the counts of a match; of contacts the longest remains.
  /// @param first  which of its teams counts as the first one
  void add(const PlayRecord& match, std::size_t first);
};
PlayRecord recordOf(const MatchStatistics& statistics);

}  // namespace fulbito
