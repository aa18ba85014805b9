#pragma once

#include <cstdint>
#include <sys/types.h>
#include <vector>

namespace fulbito::keeper {

/// What a process and those below it use.
struct Usage {
  std::uint64_t memory = 0;  ///< [bytes] resident, without pages of files
  int tasks = 0;             ///< processes and threads
};

/// All processes below a process, as the tree of parents has them now.
std::vector<pid_t> descendants(pid_t ancestor);

/// What the processes use together. Pages that several share count for each.
Usage usage(const std::vector<pid_t>& processes);

/// Whether a process is on its way to its end, or has ended and waits for its parent.
bool isEnding(pid_t process);

/// Number of processes and threads of a user on this machine.
int tasksOfUser(uid_t user);

/// Kills and reaps all descendants of this process, which has to be their subreaper, until none is left.
/// Those that a kill cannot reach for `seconds` stay behind.
void killDescendants(int seconds);

}  // namespace fulbito::keeper
