#pragma once

#include <cstddef>
#include <span>

#include "fulbito/strategy.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Numbers of an action.
std::size_t numbersOf(ActionForm form);

/// The command of an action of any form but kSkill. Numbers beyond -1 ... 1 count as the nearer end.
RobotCommand commandOf(ActionForm form, const MatchConfig& match, std::span<const float> action);

}  // namespace fulbito
