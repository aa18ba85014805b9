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

// A team can nest folders until no call takes the path. Descriptors lead further, but are few.
constexpr int kDeepest = 200;

/// Removes a folder of `root` and moves the folders inside it up to `root`, so that the depth does not
/// matter. @return whether it is removed
bool removeOneLevel(int root, const char* name, long& moved) {
  ::fchmodat(root, name, 0700, 0);
  forEntries(openFolder(root, name), [&](int from, const char* below) {
    if (::unlinkat(from, below, 0) == 0) return;
    ::fchmodat(from, below, 0700, 0);
    ::renameat(from, below, root, ("moved-" + std::to_string(++moved)).c_str());
  });
  return ::unlinkat(root, name, AT_REMOVEDIR) == 0;
}

void addSizes(int folder, int depth, std::uint64_t most, std::uint64_t& sum) {
  forEntries(folder, [&, depth](int parent, const char* name) {
    struct stat status{};
    if (sum >= most || ::fstatat(parent, name, &status, AT_SYMLINK_NOFOLLOW) != 0) return;
    const std::uint64_t size = static_cast<std::uint64_t>(status.st_blocks) * 512;
    sum += size > 512 ? size : 512;
    if (!S_ISDIR(status.st_mode)) return;
    if (depth == kDeepest) sum = most;
    if (depth < kDeepest) addSizes(openFolder(parent, name), depth + 1, most, sum);
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
  ::chmod(folder.c_str(), 0700);
  long moved = 0;
  // A pass over the entries may miss folders that have moved up. Each pass but the last removes something.
  for (bool again = true; again;) {
    again = false;
    forEntries(openFolder(AT_FDCWD, folder.c_str()), [&](int root, const char* name) {
      if (::unlinkat(root, name, 0) == 0 || removeOneLevel(root, name, moved)) again = true;
    });
  }
  ::rmdir(folder.c_str());
}

std::uint64_t treeSize(const std::string& folder, std::uint64_t most) {
  std::uint64_t sum = 0;
  addSizes(openFolder(AT_FDCWD, folder.c_str()), 0, most, sum);
  return sum;
}

}  // namespace fulbito::keeper
