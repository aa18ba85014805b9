#pragma once

#include <cstdint>
#include <string_view>

/// Events of recordings of what was heard, besides `goal`, `half` and `overtime`. Those of the referee have
/// the team that takes the restart, `value` = quadrant, and `play_time` = time of play as told.
namespace fulbito::app {

/// Frames of vision are missing before the tick, `value` of them. Bodies there move straight on.
inline constexpr std::string_view kVisionLost = "vision.lost";

/// By `wire::Foul`.
inline constexpr std::string_view kToldEvents[] = {
    "referee.free-kick", "referee.penalty", "referee.goal-kick", "referee.free-ball",
    "referee.kick-off",  "referee.stop",    "referee.game-on",   "referee.halt"};

/// What `wire::Vision::step` counts per frame [ms], as servers do.
constexpr std::uint32_t frameMilliseconds(int control_rate) {
  return static_cast<std::uint32_t>(1000.0 / control_rate);
}

}  // namespace fulbito::app
