#include "engine/core/system/output_file.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"
#include "engine/core/system/stop_request.hpp"
#include "engine/core/system/unfinished_work.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0666;  // the umask applies
constexpr int kMostNames = 1000;

tl::unexpected<Error> ioError(const std::string& what, const std::string& file, const std::string& why,
                              int reason = EIO) {
  return fail(ioCode(reason), fmt::format("cannot {} '{}': {}", what, file, why));
}

tl::unexpected<Error> cannotWrite(const std::string& file, int reason) {
  if (reason == EINTR) return fail(ErrorCode::kInterrupted, "interrupted");
  return ioError("write", file, std::generic_category().message(reason), reason);
}

/// open(2) that keeps waiting for a pipe's reader, unless the process is asked to stop.
int openWaiting(const std::string& file, int flags) {
  for (;;) {
    const int descriptor = ::open(file.c_str(), flags | O_CLOEXEC, kMode);
    if (descriptor >= 0 || errno != EINTR || stopRequested()) return descriptor;
  }
}

/// Whether the file is a device or pipe. These are written to directly, since renaming would replace them.
bool isStreamAt(const std::string& file) {
  std::error_code unknown;
  const fs::file_type kind = fs::status(file, unknown).type();
  return kind != fs::file_type::regular && kind != fs::file_type::directory &&
         kind != fs::file_type::not_found && kind != fs::file_type::none;
}

/// Path of an open descriptor, to give the file a name or to open it again.
std::string nameOf(int descriptor) { return fmt::format("/proc/{}/fd/{}", ::getpid(), descriptor); }

/// Opens a file without a name in the folder of `file`, so that no end of the process leaves it behind.
/// Returns -1 and sets errno on failure: EOPNOTSUPP where the file system or the kernel lacks such files.
int openNameless(const std::string& file) {
  fs::path folder = fs::path(file).parent_path();
  if (folder.empty()) folder = ".";
  const int descriptor = openWaiting(folder.string(), O_TMPFILE | O_RDWR);
  // Kernels and file systems without the flag report an attempt to write to a folder.
  if (descriptor < 0 && (errno == EISDIR || errno == EINVAL)) errno = EOPNOTSUPP;
  if (descriptor < 0 || ::access(nameOf(descriptor).c_str(), F_OK) == 0) return descriptor;
  ::close(descriptor);
  errno = EOPNOTSUPP;
  return -1;
}

ReplacementRule& replacementRule() {
  static ReplacementRule rule;
  return rule;
}

/// `file`, or its target if it is a link: replacing the target keeps the link.
std::string withoutLink(const std::string& file) {
  std::error_code error;
  if (!fs::is_symlink(file, error)) return file;
  const fs::path target = fs::canonical(file, error);
  return error ? file : target.string();
}

}  // namespace

struct OutputFile::Impl {
  Impl(std::string asked, std::string written_to) : name(std::move(asked)), target(std::move(written_to)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (descriptor >= 0) ::close(descriptor);
    if (listed) removePlace();
  }

  Result<void> openStream();
  /// Opens the temporary file, without a name where the file system can do that.
  Result<void> openTemporary();
  /// Calls `make` with new names for a temporary file, until one is free. False: errno says why.
  template <typename Make>
  bool underNewName(const Make& make);
  Result<void> mayReplace();
  /// Gives the complete temporary file its final name.
  bool putInPlace();
  /// False: a file of that name exists.
  Result<bool> openNew();
  Result<void> append(std::string_view bytes);
  /// Records an error, which all later calls return.
  Result<void> failWith(int reason) {
    state = cannotWrite(name, reason);
    return state;
  }
  void removePlace() {
    ::unlink(place.c_str());
    listed.reset();
  }

  const std::string name;    ///< as given by the user, for messages
  const std::string target;  ///< its name with links resolved
  std::string place;         ///< the file that holds the bytes
  int descriptor = -1;
  bool stream = false;
  bool nameless = false;                ///< the temporary file has no name before it is complete
  std::optional<TemporaryName> listed;  ///< entry for a temporary file with a name
  off_t good = 0;                       ///< bytes of complete calls of `write`
  Result<void> state;
};

Result<void> OutputFile::Impl::openStream() {
  stream = true;
  place = target;
  descriptor = openWaiting(target, O_WRONLY);
  return descriptor < 0 ? failWith(errno) : state;
}

template <typename Make>
bool OutputFile::Impl::underNewName(const Make& make) {
  static std::atomic<unsigned> next{0};
  // An existing file or link of that name belongs to another process: never truncate or follow it.
  for (int tries = 0; tries < kMostNames; ++tries) {
    place = fmt::format("{}.{}-{}.tmp", target, ::getpid(), next++);
    if (make()) {
      listed.emplace(place);
      return true;
    }
    if (errno != EEXIST) break;
  }
  return false;
}

Result<void> OutputFile::Impl::openTemporary() {
  descriptor = openNameless(target);
  nameless = descriptor >= 0;
  if (!nameless && errno != EOPNOTSUPP) return failWith(errno);
  if (nameless) place = nameOf(descriptor);
  const auto open = [&] {
    descriptor = openWaiting(place, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW);
    return descriptor >= 0;
  };
  if (!nameless && !underNewName(open)) return failWith(errno);
  struct stat old{};
  if (::stat(target.c_str(), &old) == 0) ::fchmod(descriptor, old.st_mode & 0777u);
  return {};
}

Result<void> OutputFile::Impl::mayReplace() {
  const ReplacementRule& rule = replacementRule();
  if (!rule) return {};
  std::array<char, kHeadOfFile> head{};
  const ssize_t count = ::pread(descriptor, head.data(), head.size(), 0);
  return rule(name, std::string_view(head.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))));
}

bool OutputFile::Impl::putInPlace() {
  if (nameless) {
    const std::string own = place;
    const auto link = [&](const std::string& as) {
      return ::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, as.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (link(target)) return true;
    // The target exists, and only a file with a name can replace it.
    if (errno != EEXIST || !underNewName([&] { return link(place); })) return false;
  }
  return std::rename(place.c_str(), target.c_str()) == 0;
}

Result<bool> OutputFile::Impl::openNew() {
  place = target;
  descriptor = openWaiting(target, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
  if (descriptor >= 0) return true;
  if (errno == EEXIST) return false;
  return tl::unexpected<Error>(failWith(errno).error());
}

Result<void> OutputFile::Impl::append(std::string_view bytes) {
  if (!state) return state;
  const auto whole = static_cast<off_t>(bytes.size());
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR && !(stream && stopRequested())) continue;
    if (n < 0) {
      const int reason = errno;
      // A partial line or block is worse than none.
      if (!stream && ::ftruncate(descriptor, good) != 0) good = 0;
      return failWith(reason);
    }
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  good += whole;
  return {};
}

OutputFile::OutputFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

Result<OutputFile> OutputFile::create(const std::string& file) {
  auto impl = std::make_unique<Impl>(file, withoutLink(file));
  if (auto there = checkOutputPath(file); !there) return tl::unexpected<Error>(there.error());
  const auto opened = isStreamAt(file) ? impl->openStream() : impl->openTemporary();
  if (!opened) return tl::unexpected<Error>(opened.error());
  return OutputFile(std::move(impl));
}

Result<OutputFile> OutputFile::grow(const std::string& file, bool replace) {
  if (isStreamAt(file)) return create(file);
  auto impl = std::make_unique<Impl>(file, withoutLink(file));
  if (auto there = checkOutputPath(file); !there) return tl::unexpected<Error>(there.error());
  const auto is_new = impl->openNew();
  if (!is_new) return tl::unexpected<Error>(is_new.error());
  if (*is_new) return OutputFile(std::move(impl));
  if (replace) return create(file);
  return fail(ErrorCode::kUsage, fmt::format("'{}' exists; use --force to replace it", file));
}

Result<void> OutputFile::write(std::string_view bytes) { return impl_->append(bytes); }

Result<void> OutputFile::commit(bool durable) {
  Impl& f = *impl_;
  if (f.descriptor < 0) return f.state;
  // Pipes and some file systems have no fsync.
  if (f.state && durable && ::fsync(f.descriptor) != 0 && errno != EINVAL && errno != EROFS) {
    f.failWith(errno);
  }
  const bool temporary = f.nameless || f.listed;
  if (f.state && temporary) f.state = f.mayReplace();
  if (f.state && temporary && !f.putInPlace()) f.failWith(errno);
  if (::close(std::exchange(f.descriptor, -1)) != 0 && f.state) f.failWith(errno);
  if (f.state) {
    f.listed.reset();
  } else if (f.listed || (!f.nameless && f.good == 0)) {
    discard();
  }
  return f.state;
}

void OutputFile::discard() {
  Impl& f = *impl_;
  if (f.descriptor >= 0) ::close(std::exchange(f.descriptor, -1));
  if (!f.stream && (f.listed || !f.nameless)) f.removePlace();
}

void setReplacementRule(ReplacementRule rule) { replacementRule() = std::move(rule); }

const std::string& OutputFile::place() const { return impl_->place; }
bool OutputFile::isStream() const { return impl_->stream; }

Result<void> prepareFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return ioError("create the folder", folder, error.message(), error.value());
  if (!fs::is_directory(folder, error)) return ioError("write into", folder, "it is not a folder");
  // Without `commit`, the probe is removed again.
  const auto probe = OutputFile::create(folder + "/.fulbito-probe");
  if (probe) return {};
  if (probe.error().code != ErrorCode::kIo) return tl::unexpected<Error>(probe.error());
  return ioError("write into the folder", folder, "no permission or no space");
}

Result<void> checkOutputPath(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  std::error_code error;
  if (fs::is_directory(file, error)) return ioError("write", file, "it is a folder");
  if (folder.empty() || fs::is_directory(folder, error)) return {};
  const std::string name = fmt::format("'{}'", folder.string());
  return ioError("write", file,
                 fs::exists(folder, error) ? name + " is not a folder" : "there is no folder " + name);
}

Result<void> writeFile(const std::string& file, std::string_view content, bool durable) {
  auto out = OutputFile::create(file);
  if (!out) return tl::unexpected<Error>(out.error());
  if (auto written = out->write(content); !written) return written;
  return out->commit(durable);
}

}  // namespace fulbito
