#include "engine/core/system/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"
#include "engine/core/system/regular_file.hpp"
#include "engine/core/system/stop_request.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kStep = std::size_t{1} << 18;  // [bytes] per read
constexpr int kLook = 50;                            // [ms] between checks of a pipe without a writer
constexpr int kMostLooks = 100;

struct Descriptor {
  int number;
  explicit Descriptor(int n) : number(n) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

/// Repeats a system call that a signal interrupted, unless the process is asked to stop.
template <typename Call>
auto waiting(const Call& call) {
  for (;;) {
    const auto result = call();
    if (result >= 0 || errno != EINTR || stopRequested()) return result;
  }
}

tl::unexpected<Error> cannotRead(const std::string& path, int reason) {
  if (reason == EINTR) return fail(ErrorCode::kInterrupted, "interrupted");
  return fail(ioCode(reason),
              fmt::format("cannot read '{}': {}", path, std::generic_category().message(reason)));
}

bool mayGoOn(std::string_view text, std::string_view beginning) {
  const std::size_t known = std::min(text.size(), beginning.size());
  return text.substr(0, known) == beginning.substr(0, known);
}

/// Reads an open file and waits where it has no data yet, such as a pipe.
class PatientReader {
 public:
  explicit PatientReader(int descriptor) : descriptor_(descriptor) {
    struct stat found{};
    pipe_ = ::fstat(descriptor, &found) == 0 && S_ISFIFO(found.st_mode);
  }

  /// As read(2). Waits some seconds for the first writer of a pipe, then fails with ENODATA.
  ssize_t read(char* to, std::size_t room) {
    for (int looks = 0;;) {
      const ssize_t count = waiting([&] { return ::read(descriptor_, to, room); });
      if (count < 0 && errno != EAGAIN) return count;
      if (count > 0 || (count == 0 && (written_ || !pipe_))) {
        written_ = true;
        return count;
      }
      written_ = written_ || count < 0;
      if (count == 0 && ++looks > kMostLooks) {
        errno = ENODATA;
        return -1;
      }
      pollfd more{descriptor_, POLLIN, 0};
      // Without a writer, poll may report a hang-up at once. So this case waits without looking at the pipe.
      const int waited = count < 0 ? ::poll(&more, 1, -1) : ::poll(nullptr, 0, kLook);
      if (waited < 0 && (errno != EINTR || stopRequested())) return -1;
    }
  }

 private:
  int descriptor_;
  bool pipe_ = false;
  bool written_ = false;  ///< the pipe has had a writer
};

Result<std::string> readOpen(int descriptor, const std::string& path, std::size_t max_bytes,
                             std::string_view beginning) {
  PatientReader reader(descriptor);
  std::string text;
  while (text.size() <= max_bytes && mayGoOn(text, beginning)) {
    const std::size_t begin = text.size();
    const std::size_t room =
        std::min(begin < beginning.size() ? beginning.size() - begin : kStep, max_bytes + 1 - begin);
    text.resize(begin + room);
    const ssize_t count = reader.read(text.data() + begin, room);
    if (count < 0 && errno == ENODATA) {
      return fail(ErrorCode::kIo,
                  fmt::format("cannot read '{}': it is a pipe into which nobody writes", path));
    }
    if (count < 0) return cannotRead(path, errno);
    text.resize(begin + static_cast<std::size_t>(count));
    if (count == 0) break;
  }
  if (text.size() > max_bytes) {
    return fail(ErrorCode::kBadInput, fmt::format("{}: larger than the limit of {} bytes", path, max_bytes));
  }
  return text;
}

}  // namespace

Result<std::string> readTextFile(const std::string& path, std::size_t max_bytes, std::string_view beginning) {
  // A name with a zero byte would silently open another file.
  if (path.empty() || path.find('\0') != std::string::npos) return cannotRead(path, ENOENT);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return cannotRead(path, EISDIR);
  const Descriptor file(
      waiting([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY); }));
  if (file.number < 0) return cannotRead(path, errno);
  return readOpen(file.number, path, max_bytes, beginning);
}

Result<std::string> readFoundFile(const std::string& path, std::size_t max_bytes,
                                  std::string_view beginning) {
  const auto file = RegularFile::open("read", path, O_RDONLY);
  if (!file) return tl::unexpected<Error>(file.error());
  return readOpen(file->descriptor(), path, max_bytes, beginning);
}

}  // namespace fulbito
