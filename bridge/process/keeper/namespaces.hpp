#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Starts a process: in a PID and a mount namespace if that is possible, for an ordinary user in a user
/// namespace too. Sets own_pids and own_users. `with_namespaces`: otherwise a plain fork.
/// @return as fork; -1 with errno if the namespaces cannot be had
pid_t forkInNamespaces(Order& order, bool with_namespaces);

/// In the new process: maps its user. @return 0, or an errno
int mapUser(const Order& order);

/// In the new process: makes all files unwritable and the private folder one of limited size. Says
/// in `why` what fails. @return 0, or an errno
int restrictMounts(Order& order, std::string& why);

}  // namespace fulbito::keeper
