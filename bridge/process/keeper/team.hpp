#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Turns this process into the team's program, with all restrictions that a process sets for itself. `parent`
/// has started it, `keeper` watches it. Failures go into the page.
[[noreturn]] void becomeTeam(Order& order, pid_t parent, pid_t keeper);

}  // namespace fulbito::keeper
