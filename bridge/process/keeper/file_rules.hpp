#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Restricts this process and its children by Landlock. Readable: the system's programs and libraries, the
/// team's folder, the program's surroundings. Writable: the private folder. Nothing else. If the kernel
/// supports it, also no TCP without `network`, and no signals to processes outside. Puts what is missing into
/// `why`. @return 0, or an errno
int restrictFiles(const Order& order, std::string& why);

}  // namespace fulbito::keeper
