#pragma once

#include <cstdint>
#include <optional>

#include "fulbito/detail/values.hpp"

namespace fulbito::libero {

/// What a robot is in the team, numbered as `TeamCommand::roles` are.
enum class Role : std::uint8_t { kKeeper = 1, kStriker, kSupport };

/// What a skill decided for a robot in one tick: the twist is driven, as far as areas and keepers allow, the
/// rest shown.
struct Move {
  Twist twist;
  const char* skill = "";      ///< name of what is done, where it is not the role's usual
  std::optional<Vec2> place;   ///< [m] where the robot is going
  std::optional<Vec2> ball;    ///< [m] where it means to touch the ball
  std::optional<Vec2> target;  ///< [m] where it means to send the ball
};

}  // namespace fulbito::libero
