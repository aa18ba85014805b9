#pragma once

#include <string>
#include <sys/types.h>

namespace fulbito {

/// A name on the process's list of files that are not whole yet. Whoever ends the process in the middle of
/// its work removes what is on the list.
class TemporaryName {
 public:
  /// Lists the name. Where the list is full or the name too long the file is only not removed early.
  explicit TemporaryName(const std::string& file);
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  /// Takes the name off the list; the file is the owner's.
  ~TemporaryName();

 private:
  int slot_;
};

/// The one helper process that works for this one at a time and must not outlive it; 0: none.
void setHelperProcess(pid_t process) noexcept;

/// Kills the helper process and removes all files on the list. Calls nothing that a signal handler must not
/// call.
void abandonUnfinishedWork() noexcept;

}  // namespace fulbito
