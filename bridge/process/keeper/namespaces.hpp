#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Starts a process like fork. `with_namespaces`: in a PID and a mount namespace, for an ordinary user also
/// in a user namespace, and in a network namespace if the order has sockets. Sets own_pids and own_users.
/// @return as fork; -1 with errno if the system refuses the namespaces
pid_t forkInNamespaces(Order& order, bool with_namespaces);

/// In the new process: maps its user. @return 0, or an errno
int mapUser(const Order& order);

/// In the new process: makes all files unwritable, and mounts a private folder of limited size. Puts what
/// fails into `why`. @return 0, or an errno
int restrictMounts(Order& order, std::string& why);

}  // namespace fulbito::keeper
