#include "bridge/process/keeper/files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace fulbito::keeper {
namespace {

bool isItselfOrParent(const char* name) {
  return std::string_view(name) == "." || std::string_view(name) == "..";
}

/// Calls `visit(descriptor of the folder, name)` for each entry. Closes `folder`.
template <typename Visit>
void forEntries(int folder, Visit visit) {
  if (folder < 0) return;
  DIR* stream = ::fdopendir(folder);
  if (stream == nullptr) {
    ::close(folder);
    return;
  }
  while (const dirent* entry = ::readdir(stream)) {
    if (!isItselfOrParent(entry->d_name)) visit(::dirfd(stream), entry->d_name);
  }
  ::closedir(stream);
}

int openFolder(int parent, const char* name) {
  return ::openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

// A team can nest folders until the path is too long for any call, so removal and size go by descriptors. The
// depth that they follow stays below the limit of descriptors.
constexpr int kDeepest = 200;

void removeEntries(int folder, int depth) {
  forEntries(folder, [depth](int parent, const char* name) {
    if (::unlinkat(parent, name, 0) == 0) return;
    ::fchmodat(parent, name, 0700, 0);
    if (depth < kDeepest) removeEntries(openFolder(parent, name), depth + 1);
    if (::unlinkat(parent, name, AT_REMOVEDIR) == 0 || depth < kDeepest) return;
    // Too deep: what it holds moves up to a level that is still in reach.
    forEntries(openFolder(parent, name), [parent](int from, const char* below) {
      for (int number = 0; number < 1000; ++number) {
        const std::string free_name = "moved-" + std::to_string(number);
        if (::faccessat(parent, free_name.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0) continue;
        if (::renameat(from, below, parent, free_name.c_str()) == 0) return;
      }
    });
    ::unlinkat(parent, name, AT_REMOVEDIR);
  });
}

void addSizes(int folder, int depth, std::uint64_t most, std::uint64_t& sum) {
  forEntries(folder, [&, depth](int parent, const char* name) {
    struct stat status{};
    if (sum >= most || ::fstatat(parent, name, &status, AT_SYMLINK_NOFOLLOW) != 0) return;
    const std::uint64_t size = static_cast<std::uint64_t>(status.st_blocks) * 512;
    sum += size > 512 ? size : 512;
    if (S_ISDIR(status.st_mode) && depth < kDeepest) addSizes(openFolder(parent, name), depth + 1, most, sum);
  });
}

}  // namespace

std::string readSmallFile(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};
  std::string text(65536, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t got = ::read(file, text.data() + size, text.size() - size);
    if (got <= 0) break;
    size += static_cast<std::size_t>(got);
  }
  ::close(file);
  text.resize(size);
  return text;
}

bool writeSmallFile(const std::string& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const ssize_t wrote = ::write(file, text.data(), text.size());
  const int error = errno;
  ::close(file);
  errno = error;
  return wrote == static_cast<ssize_t>(text.size());
}

void removeTree(const std::string& folder) {
  // What was too deep for one pass has moved up for the next.
  for (int pass = 0; pass < 100; ++pass) {
    ::chmod(folder.c_str(), 0700);
    removeEntries(openFolder(AT_FDCWD, folder.c_str()), 0);
    if (::rmdir(folder.c_str()) == 0 || errno == ENOENT) return;
  }
}

std::uint64_t treeSize(const std::string& folder, std::uint64_t most) {
  std::uint64_t sum = 0;
  addSizes(openFolder(AT_FDCWD, folder.c_str()), 0, most, sum);
  return sum;
}

}  // namespace fulbito::keeper
