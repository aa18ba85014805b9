#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// In the first process of a network namespace: makes its loopback carry all packets, multicast too, and
/// sends sockets of this network through `kStartDescriptor`. The launcher thus talks to a team that nobody
/// else hears. Ends this process if that fails.
void openNetwork(Order& order);

}  // namespace fulbito::keeper
