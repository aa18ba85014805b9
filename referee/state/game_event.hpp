#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"

namespace fulbito {

/// One call of the referee, with its measured value.
struct GameEvent {
  Tick tick = 0;                      ///< of the match
  double play_time = 0.0;             ///< [s] play time in the period
  std::uint8_t period = 1;            ///< 1, 2: halves; 3: overtime; 4: shoot-out
  std::string_view clause;            ///< name of the rule, e.g. "goal-kick.attackers"; static lifetime
  std::string_view law;               ///< section of the rule book, e.g. "8.2"; static lifetime
  std::optional<TeamId> team;         ///< team that the call is against; for a goal, the scoring team
  std::optional<std::uint8_t> robot;  ///< the robot at fault or the scorer, if known
  Vec2 place;                         ///< [m] the ball's position, world frame
  double value = 0.0;                 ///< measured value, in the unit of the threshold
  double threshold = 0.0;             ///< limit of the rule
  double margin = 0.0;                ///< distance of the value from the limit; positive
};

}  // namespace fulbito
