#include "engine/core/system/regular_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"
#include "engine/core/system/repeat_call.hpp"

namespace fulbito {
namespace {

constexpr mode_t kMode = 0666;  // the umask applies

}  // namespace

tl::unexpected<Error> ioFailure(const char* what, const std::string& file, int reason) {
  return fail(ioCode(reason),
              fmt::format("cannot {} '{}': {}", what, file, std::generic_category().message(reason)));
}

Result<RegularFile> RegularFile::open(const char* what, const std::string& file, int flags) {
  // A name with a zero byte would silently open another file.
  if (file.find('\0') != std::string::npos) return ioFailure(what, file.c_str(), EINVAL);
  constexpr int kNeverWait = O_NONBLOCK | O_NOCTTY;
  RegularFile opened(repeatCall([&] { return ::open(file.c_str(), flags | O_CLOEXEC | kNeverWait, kMode); }));
  struct stat found{};
  if (opened.descriptor_ < 0 || ::fstat(opened.descriptor_, &found) != 0) return ioFailure(what, file, errno);
  if (S_ISREG(found.st_mode)) return opened;
  if (S_ISDIR(found.st_mode)) return ioFailure(what, file, EISDIR);
  return fail(ErrorCode::kIo, fmt::format("cannot {} '{}': it is not a regular file", what, file));
}

RegularFile::RegularFile(RegularFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

RegularFile& RegularFile::operator=(RegularFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> syncFolderOf(const std::string& file) {
  constexpr const char* kWhat = "sync the folder of";
  std::error_code error;
  // If the file is a link, its target's folder holds the new name.
  const std::filesystem::path folder = std::filesystem::canonical(file, error).parent_path();
  if (error) return ioFailure(kWhat, file, error.value());
  const int descriptor =
      repeatCall([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
  if (descriptor < 0) return ioFailure(kWhat, file, errno);
  // Some file systems have no fsync for folders.
  const bool synced = repeatCall([&] { return ::fsync(descriptor); }) == 0 || errno == EINVAL;
  const int reason = errno;
  ::close(descriptor);
  return synced ? Result<void>() : ioFailure(kWhat, file, reason);
}

}  // namespace fulbito
