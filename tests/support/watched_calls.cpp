#include "tests/support/watched_calls.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <fcntl.h>
#include <mutex>
#include <sstream>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <utility>

#include <climits>

namespace fulbito::test {
namespace {

constexpr std::string_view kNames[] = {"open",   "read",     "write", "sync",
                                       "rename", "truncate", "lock",  "folder"};

struct Watch {
  std::mutex mutex;
  std::atomic<bool> active{false};
  std::string folder;
  std::vector<Fault> faults;
  std::array<int, std::size(kNames)> counts{};
  std::vector<std::string> trace;
};

Fault faultOf(const char* text) {
  Fault fault;
  std::istringstream words(text);
  std::string name, more;
  words >> name >> fault.nth >> fault.error;
  for (const Call call : kCalls) {
    if (name == nameOf(call)) fault.call = call;
  }
  while (words >> more) (more == "half" ? fault.half : fault.lasting) = true;
  return fault;
}

Watch& watch() {
  static Watch* const only = [] {  // never destroyed: streams still write at the end of the process
    auto* const made = new Watch;
    const char* const folder = std::getenv("FULBITO_FAULT_BELOW");
    const char* const fault = std::getenv("FULBITO_FAULT");
    if (folder != nullptr && fault != nullptr) {
      made->folder = folder;
      made->faults = {faultOf(fault)};
      made->active = true;
    }
    return made;
  }();
  return *only;
}

std::string pathOf(int descriptor) {
  char path[PATH_MAX];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const long size = ::syscall(SYS_readlinkat, AT_FDCWD, link.c_str(), path, sizeof path);
  return size < 0 ? std::string() : std::string(path, static_cast<std::size_t>(size));
}

std::string pathOf(const char* path) { return path; }

/// What happens to a call.
enum class Fate : std::uint8_t { kMade, kHalf, kFails };

Fate fateAt(const Fault& fault, int count) {
  if (fault.nth == 0 || count < fault.nth) return Fate::kMade;
  if (fault.half && count == fault.nth) return Fate::kHalf;
  const int first = fault.half ? fault.nth + 1 : fault.nth;
  return count == first || fault.lasting ? Fate::kFails : Fate::kMade;
}

/// Counts a call; a failing one has its errno afterwards. `file`: a descriptor or a path.
template <typename File>
Fate fateOf(Call call, File file) {
  Watch& w = watch();
  if (!w.active) return Fate::kMade;
  const int before = errno;
  const std::string path = pathOf(file);
  errno = before;
  const std::lock_guard lock(w.mutex);
  if (!path.starts_with(w.folder)) return Fate::kMade;
  w.trace.push_back(nameOf(call) + (" " + path.substr(std::min(path.size(), w.folder.size() + 1))));
  const int count = ++w.counts[static_cast<std::size_t>(call)];
  for (const Fault& fault : w.faults) {
    const Fate fate = fault.call == call ? fateAt(fault, count) : Fate::kMade;
    if (fate == Fate::kMade) continue;
    if (fate == Fate::kFails && fault.error == 0) ::raise(SIGKILL);
    errno = fault.error;
    return fate;
  }
  return Fate::kMade;
}

/// Makes a call, if that is its fate.
template <typename File, typename... Arguments>
long made(Call call, File file, long number, Arguments... arguments) {
  return fateOf(call, file) == Fate::kMade ? ::syscall(number, arguments...) : -1;
}

/// A sync that is watched is not made.
int synced(int descriptor, long number) {
  if (!watch().active) return static_cast<int>(::syscall(number, descriptor));
  return fateOf(Call::kSync, descriptor) == Fate::kMade ? 0 : -1;
}

ssize_t written(int descriptor, const void* bytes, std::size_t size) {
  const Fate fate = fateOf(Call::kWrite, descriptor);
  if (fate == Fate::kFails) return -1;
  return ::syscall(SYS_write, descriptor, bytes, fate == Fate::kHalf ? size / 2 : size);
}

}  // namespace

const char* nameOf(Call call) { return kNames[static_cast<std::size_t>(call)].data(); }

WatchedCalls::WatchedCalls(const std::string& folder, std::vector<Fault> faults) {
  Watch& w = watch();
  const std::lock_guard lock(w.mutex);
  w.counts = {};
  w.trace.clear();
  w.faults = std::move(faults);
  w.folder = folder;
  w.active = true;
}

WatchedCalls::~WatchedCalls() { watch().active = false; }

int WatchedCalls::count(Call call) const {
  const std::lock_guard lock(watch().mutex);
  return watch().counts[static_cast<std::size_t>(call)];
}

std::vector<std::string> WatchedCalls::trace() const {
  const std::lock_guard lock(watch().mutex);
  return watch().trace;
}

}  // namespace fulbito::test

// These names take the place of the C library's.
extern "C" {

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  using namespace fulbito::test;
  return static_cast<int>(made(Call::kOpen, path, SYS_openat, AT_FDCWD, path, flags, mode));
}

ssize_t read(int descriptor, void* bytes, std::size_t size) {
  using namespace fulbito::test;
  return made(Call::kRead, descriptor, SYS_read, descriptor, bytes, size);
}

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  return fulbito::test::written(descriptor, bytes, size);
}

int fsync(int descriptor) { return fulbito::test::synced(descriptor, SYS_fsync); }
int fdatasync(int descriptor) { return fulbito::test::synced(descriptor, SYS_fdatasync); }

int rename(const char* from, const char* to) noexcept {
  using namespace fulbito::test;
  return static_cast<int>(made(Call::kRename, to, SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

// What gives a nameless file its name counts as a rename.
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  using namespace fulbito::test;
  return static_cast<int>(made(Call::kRename, to, SYS_linkat, from_folder, from, to_folder, to, flags));
}

int ftruncate(int descriptor, off_t size) noexcept {
  using namespace fulbito::test;
  return static_cast<int>(made(Call::kTruncate, descriptor, SYS_ftruncate, descriptor, size));
}

int flock(int descriptor, int operation) noexcept {
  using namespace fulbito::test;
  return static_cast<int>(made(Call::kLock, descriptor, SYS_flock, descriptor, operation));
}

int mkdir(const char* path, mode_t mode) noexcept {
  using namespace fulbito::test;
  return static_cast<int>(made(Call::kFolder, path, SYS_mkdirat, AT_FDCWD, path, mode));
}

}  // extern "C"
