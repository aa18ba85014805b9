#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Installs the seccomp filter of a team for this process and what it starts. `keeper` and the launcher are
/// spared signals where nothing else spares them. @return 0, or an errno
int filterSyscalls(const Order& order, pid_t keeper);

}  // namespace fulbito::keeper
