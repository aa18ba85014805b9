#include "engine/core/system/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "engine/core/system/shortage.hpp"
#include "engine/core/system/stop_request.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kStep = std::size_t{1} << 18;  // [bytes] per read

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
  return fail(isShortage(reason) ? ErrorCode::kMachine : ErrorCode::kIo,
              fmt::format("cannot read '{}': {}", path, std::generic_category().message(reason)));
}

bool mayGoOn(std::string_view text, std::string_view beginning) {
  const std::size_t known = std::min(text.size(), beginning.size());
  return text.substr(0, known) == beginning.substr(0, known);
}

}  // namespace

Result<std::string> readTextFile(const std::string& path, std::size_t max_bytes, std::string_view beginning) {
  // A name with a zero byte would silently open another file.
  if (path.empty() || path.find('\0') != std::string::npos) return cannotRead(path, ENOENT);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return cannotRead(path, EISDIR);
  const Descriptor file(waiting([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }));
  if (file.number < 0) return cannotRead(path, errno);
  std::string text;
  while (text.size() <= max_bytes && mayGoOn(text, beginning)) {
    const std::size_t begin = text.size();
    const std::size_t room =
        std::min(begin < beginning.size() ? beginning.size() - begin : kStep, max_bytes + 1 - begin);
    text.resize(begin + room);
    const ssize_t count = waiting([&] { return ::read(file.number, text.data() + begin, room); });
    if (count < 0) return cannotRead(path, errno);
    text.resize(begin + static_cast<std::size_t>(count));
    if (count == 0) break;
  }
  if (text.size() > max_bytes) {
    return fail(ErrorCode::kBadInput, fmt::format("{}: larger than the limit of {} bytes", path, max_bytes));
  }
  return text;
}

}  // namespace fulbito
