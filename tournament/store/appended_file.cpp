#include "tournament/store/appended_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "engine/core/system/repeat_call.hpp"

namespace fulbito {
namespace {

constexpr const char* kWhat = "write";

Result<void> lock(int descriptor, const std::string& file) {
  if (repeatCall([&] { return ::flock(descriptor, LOCK_EX | LOCK_NB); }) == 0) return {};
  if (errno != EWOULDBLOCK) return ioFailure("lock", file, errno);
  return fail(
      ErrorCode::kUsage,
      fmt::format("'{}' is being written by another run; wait for its end, or name another file", file));
}

}  // namespace

Result<AppendedFile> AppendedFile::open(const std::string& file) {
  auto opened = RegularFile::open(kWhat, file, O_RDWR | O_CREAT | O_APPEND);
  if (!opened) return tl::unexpected<Error>(opened.error());
  if (auto locked = lock(opened->descriptor(), file); !locked) return tl::unexpected<Error>(locked.error());
  return AppendedFile(file, std::move(*opened));
}

Result<void> AppendedFile::begin(std::uint64_t size) {
  const int cut = repeatCall([&] { return ::ftruncate(descriptor(), static_cast<off_t>(size)); });
  if (cut != 0) return ioFailure(kWhat, file_, errno);
  size_ = size;
  return sync().and_then([&] { return syncFolderOf(file_); });
}

Result<void> AppendedFile::append(std::string_view line) {
  if (state_) state_ = appendAt(line);
  return state_;
}

Result<void> AppendedFile::appendAt(std::string_view line) {
  // Checked before and after: lines written to a file that has been removed are lost.
  auto done = checkPlace();
  if (!done) return done;
  done = write(line).and_then([&] { return sync(); });
  if (!done) {
    // If this fails too, the next run finds the torn line and cuts it off.
    [[maybe_unused]] const int cut = ::ftruncate(descriptor(), static_cast<off_t>(size_));
    return done;
  }
  size_ += line.size();
  return checkPlace();
}

Result<void> AppendedFile::checkPlace() const {
  struct stat mine{}, named{};
  if (::fstat(descriptor(), &mine) != 0 || ::stat(file_.c_str(), &named) != 0) {
    return ioFailure(kWhat, file_, errno);
  }
  const char* problem = nullptr;
  if (mine.st_ino != named.st_ino || mine.st_dev != named.st_dev) problem = "replaced";
  if (!problem && static_cast<std::uint64_t>(mine.st_size) != size_) problem = "changed";
  if (!problem) return {};
  return fail(ErrorCode::kIo, fmt::format("cannot write '{}': another program {} it", file_, problem));
}

Result<void> AppendedFile::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = repeatCall([&] { return ::write(descriptor(), bytes.data(), bytes.size()); });
    if (n < 0) return ioFailure(kWhat, file_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

Result<void> AppendedFile::sync() const {
  const int synced = repeatCall([&] { return ::fdatasync(descriptor()); });
  // Some file systems do not support fsync; they report EINVAL.
  return synced == 0 || errno == EINVAL ? Result<void>() : ioFailure(kWhat, file_, errno);
}

}  // namespace fulbito
