#pragma once

#include <optional>

#include "strategies/teams/libero/playbook/memory.hpp"
#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// A skill: what `robot` does in this tick; empty if the skill has no answer to the situation. It may keep
/// what it must remember in the robot's memory.
using SkillFunction = std::optional<Move>(const Picture& picture, int robot, Memory& memory);

// Declares every skill of the play book in the namespace of its role, e.g. `striker::strike`.
#define SKILL(role, name, function, summary) \
  namespace role {                           \
  SkillFunction function;                    \
  }
#include "strategies/teams/libero/playbook/playbook.def"

}  // namespace fulbito::libero
