#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// The control group of a child, of version 2 or of version 1. Removed at the end.
class Cgroup {
 public:
  Cgroup() = default;
  Cgroup(const Cgroup&) = delete;
  Cgroup& operator=(const Cgroup&) = delete;
  ~Cgroup();

  /// Makes a group with the order's limits of memory and processes, below or next to the group of this
  /// process. @return whether the group limits memory
  bool make(const Order& order);
  /// Its folders.
  const std::vector<std::string>& folders() const { return folders_; }
  /// Puts a process into the group.
  bool add(pid_t process) const;
  /// Whether the kernel killed a process because the group reached its limit of memory.
  bool ranOut() const;
  /// Whether the kernel killed a process because memory ran out elsewhere: in a group around it, or on the
  /// machine.
  bool othersRanOut() const;

 private:
  bool lostProcess() const;
  bool reachedLimit() const;
  bool makeVersion2(const Order& order, const std::string& parent);
  bool makeVersion1(const Order& order, const std::string& memory_parent, const std::string& pids_parent);

  std::vector<std::string> folders_;
  bool version2_ = false;
};

}  // namespace fulbito::keeper
