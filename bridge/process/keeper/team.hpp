#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Turns this process into the team's program, with all that restricts a process itself. `parent` has started
/// it, `keeper` watches. What fails goes into the page.
[[noreturn]] void becomeTeam(Order& order, pid_t parent, pid_t keeper);

}  // namespace fulbito::keeper
