#pragma once

#include <string>
#include <sys/types.h>

namespace fulbito {

/// An entry in the process's list of unfinished files. `abandonUnfinishedWork` removes these files when the
/// process must end early.
class TemporaryName {
 public:
  /// Adds the name. If the list is full or the name too long, the file is not removed early.
  explicit TemporaryName(const std::string& file);
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  /// Removes the name from the list; the file stays.
  ~TemporaryName();

 private:
  int slot_;
};

/// Sets the one helper process that must not outlive this process; 0: none.
void setHelperProcess(pid_t process) noexcept;

/// Kills the helper process and removes all files on the list. Safe in signal handlers.
void abandonUnfinishedWork() noexcept;

}  // namespace fulbito
