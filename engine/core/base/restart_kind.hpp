#pragma once

#include <cstddef>
#include <cstdint>

namespace fulbito {

/// How play begins. The numbers are part of the recording format: append, never renumber.
enum class RestartKind : std::uint8_t {
  kKickOff,
  kFreeBall,
  kFreeKick,
  kPenalty,
  kGoalKick,
  kGiven  ///< from a placement by the user or a drill
};

constexpr const char* nameOf(RestartKind kind) {
  constexpr const char* names[] = {"kick-off", "free-ball", "free-kick", "penalty", "goal-kick", "given"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace fulbito
