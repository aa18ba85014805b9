#include "engine/core/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

namespace fulbito {
namespace {

tl::unexpected<Error> ioError(const std::string& what, const std::string& file, const std::string& why) {
  return fail(ErrorCode::kIo, fmt::format("cannot {} '{}': {}", what, file, why));
}

/// Writes all of `content`, down to the disk where `durable`; on failure errno says why.
bool writeAll(int descriptor, const std::string& content, bool durable = true) {
  std::size_t written = 0;
  while (written < content.size()) {
    const ssize_t n = ::write(descriptor, content.data() + written, content.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    written += static_cast<std::size_t>(n);
  }
  return !durable || ::fsync(descriptor) == 0 || errno == EINVAL ||
         errno == EROFS;  // pipes and some file systems have no fsync
}

/// Renaming over a device or pipe would take its place, e.g. that of /dev/null.
Result<void> writeDevice(const std::string& file, const std::string& content) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return ioError("write", file, std::strerror(errno));
  const bool complete = writeAll(descriptor, content);
  const int reason = errno;
  if (::close(descriptor) != 0 || !complete)
    return ioError("write", file, std::strerror(complete ? errno : reason));
  return {};
}

}  // namespace

Result<void> prepareFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return ioError("make the folder", folder, error.message());
  if (!std::filesystem::is_directory(folder, error))
    return ioError("write into", folder, "it is not a folder");
  const std::string probe = folder + "/.fulbito-probe";
  auto written = writeFile(probe, "");
  if (!written) return ioError("write into the folder", folder, "no permission or no space");
  std::filesystem::remove(probe, error);
  return {};
}

Result<void> checkPlaceOf(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return ioError("write", file, "it is a folder");
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return {};
  const std::string name = fmt::format("'{}'", folder.string());
  return ioError(
      "write", file,
      std::filesystem::exists(folder, error) ? name + " is not a folder" : "there is no folder " + name);
}

Result<void> writeFile(const std::string& file, const std::string& content, bool durable) {
  std::error_code unknown;
  const auto kind = std::filesystem::status(file, unknown).type();
  if (kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::fifo) {
    return writeDevice(file, content);
  }
  if (auto there = checkPlaceOf(file); !there) return there;
  const std::string temporary = fmt::format("{}.{}.tmp", file, ::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return ioError("write", file, std::strerror(errno));
  const bool complete = writeAll(descriptor, content, durable);
  const int reason = errno;
  if (::close(descriptor) != 0 || !complete || std::rename(temporary.c_str(), file.c_str()) != 0) {
    const int why = complete ? errno : reason;
    ::unlink(temporary.c_str());
    return ioError("write", file, std::strerror(why));
  }
  return {};
}

}  // namespace fulbito
