#pragma once

#include <cstdint>
#include <optional>

#include "fulbito/detail/values.hpp"

namespace fulbito::libero {

/// A robot's role in the team, numbered as in `TeamCommand::roles`.
enum class Role : std::uint8_t { kKeeper = 1, kStriker, kSupport };

/// A skill's decision for a robot in one tick. The robot drives the twist, as far as areas and keepers allow;
/// the rest is for drawings.
struct Move {
  Twist twist = {};
  const char* reason = "";          ///< why the skill answers now, in a few words
  std::optional<Vec2> place = {};   ///< [m] the robot's target
  std::optional<Vec2> ball = {};    ///< [m] where the robot will touch the ball
  std::optional<Vec2> target = {};  ///< [m] where the robot will send the ball
  bool travels = false;             ///< goes to `place` without the ball: a navigator may drive instead
  const char* skill = "";           ///< name of the skill; the play book fills it in
};

}  // namespace fulbito::libero
