#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fulbito::test {

/// System calls that files depend on.
enum class Call : std::uint8_t { kOpen, kRead, kWrite, kSync, kRename, kTruncate, kLock, kFolder };
inline constexpr Call kCalls[] = {Call::kOpen,   Call::kRead,     Call::kWrite, Call::kSync,
                                  Call::kRename, Call::kTruncate, Call::kLock,  Call::kFolder};
/// "open", "read", "write", "sync" (fsync and fdatasync), "rename", "truncate", "lock" (flock), "folder"
/// (mkdir).
const char* nameOf(Call call);

/// What happens to one call, counted from 1 over its kind. The default: nothing.
struct Fault {
  Call call = Call::kWrite;
  int nth = 0;           ///< 0: never
  int error = 0;         ///< errno that the call fails with; 0: the process dies instead, as by kill -9
  bool half = false;     ///< of a write: half of its bytes are written, and the next call fails
  bool lasting = false;  ///< all later calls of this kind fail too
};

/// While it lives, counts the calls of this process on files below a folder, and lets some go wrong. Syncs
/// are only counted: that they reach a disk is the kernel's business. One at a time.
///
/// The test program's own `open`, `write`, ... take the place of the C library's, in the libraries under test
/// too. As a shared library, watched_calls.cpp does the same to a whole program: LD_PRELOAD with
/// FULBITO_FAULT_BELOW=FOLDER and FULBITO_FAULT="write 3 28 half lasting".
class WatchedCalls {
 public:
  explicit WatchedCalls(const std::string& folder, std::vector<Fault> faults = {});
  WatchedCalls(const WatchedCalls&) = delete;
  WatchedCalls& operator=(const WatchedCalls&) = delete;
  ~WatchedCalls();

  int count(Call call) const;
  /// All calls so far, such as "write log.jsonl", by names below the folder.
  std::vector<std::string> trace() const;
};

}  // namespace fulbito::test
