#pragma once

#include <cstdint>

#include "fulbito/statistics.hpp"

namespace fulbito {

/// What a result keeps of a team's statistics.
struct TeamRecord : TeamPlay {
  std::int64_t shots = 0, shots_on_goal = 0, own_goals = 0;
  Tick own_third = 0;  ///< ticks with the ball in its own third
};

/// A count of a `TeamRecord`, and its key in files.
struct PlayCount {
  const char* key;
  std::int64_t TeamRecord::* count;
};
/// All counts, in the order of files.
inline constexpr PlayCount kPlayCounts[] = {{"shots", &TeamRecord::shots},
                                            {"shots_on_goal", &TeamRecord::shots_on_goal},
                                            {"own_goals", &TeamRecord::own_goals},
                                            {"own_third", &TeamRecord::own_third},
                                            {"robots", &TeamRecord::robot_ticks},
                                            {"slow", &TeamRecord::slow_ticks},
                                            {"field", &TeamRecord::field_ticks},
                                            {"field_slow", &TeamRecord::field_slow_ticks},
                                            {"own_half", &TeamRecord::own_half},
                                            {"keeper_away", &TeamRecord::keeper_away},
                                            {"uncovered", &TeamRecord::uncovered},
                                            {"field_uncovered", &TeamRecord::field_uncovered},
                                            {"locks", &TeamRecord::locks},
                                            {"long_contacts", &TeamRecord::long_contacts},
                                            {"longest_contact", &TeamRecord::longest_contact}};

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
