#pragma once

#include <cstddef>

namespace fulbito {

/// Limits of a team's process with all its descendants. They bind root too.
struct ChildLimits {
  std::size_t memory = std::size_t{1}
                       << 30;  ///< [bytes] of all its processes, without reserved address space
  std::size_t file_size = std::size_t{1} << 24;    ///< [bytes] largest file that it may write
  std::size_t folder_size = std::size_t{1} << 26;  ///< [bytes] of all files in its private folder
  int open_files = 256;                            ///< descriptors of a process
  int processes = 64;                              ///< processes and threads
  int cpu_seconds = 24 * 3600;                     ///< [s] processor time of a process
  bool network = false;                            ///< sockets other than those it is given
};

}  // namespace fulbito
