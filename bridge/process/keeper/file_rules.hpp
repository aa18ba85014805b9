#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Restricts this process and what it starts by Landlock: the system's programs and libraries, the team's
/// folder and the program's surroundings are readable, the private folder is writable, nothing else. Where
/// the kernel can, no TCP without `network` and no signals to processes outside. Says in `why` what is
/// missing. @return 0, or an errno
int restrictFiles(const Order& order, std::string& why);

}  // namespace fulbito::keeper
