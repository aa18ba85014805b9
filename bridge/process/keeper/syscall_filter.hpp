#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Installs the seccomp filter of a team for this process and its children. Without a namespace, it also
/// refuses signals to `keeper` and the launcher. @return 0, or an errno
int filterSyscalls(const Order& order, pid_t keeper);

}  // namespace fulbito::keeper
