#pragma once

#include <cstdint>
#include <sys/types.h>
#include <vector>

namespace fulbito::keeper {

/// Resources that a group of processes uses.
struct Usage {
  std::uint64_t memory = 0;  ///< [bytes] resident, without pages of files
  int tasks = 0;             ///< processes and threads
};

/// All descendants of a process at this moment.
std::vector<pid_t> descendants(pid_t ancestor);

/// The sum over the processes. A page that several share counts for each.
Usage usage(const std::vector<pid_t>& processes);

/// Whether a process is exiting, or has ended and waits for its parent.
bool isEnding(pid_t process);

/// Number of processes and threads of a user on this machine.
int tasksOfUser(uid_t user);

/// Kills and reaps all descendants of this process, which must be their subreaper, until none is left. Gives
/// up after `seconds`, if processes cannot be killed.
void killDescendants(int seconds);

}  // namespace fulbito::keeper
