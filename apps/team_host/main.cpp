// Runs a team of a shared library in its own process. Messages of `bridge/abi/frames.hpp` arrive on standard
// input; replies go to standard output. Text that the team prints goes to standard error.

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include "bridge/abi/frames.hpp"
#include "bridge/abi/team_host.hpp"

namespace fulbito {
namespace {

constexpr int kUsage = 2, kBadInput = 3, kIo = 5;  // exit codes, the same as those of the program `fulbito`
constexpr std::size_t kLongestReason = 2000;       // [bytes] short enough that a pipe takes it at once

// Times of busy waiting. Two teams that take turns need some microseconds; a wait for other work takes
// longer.
constexpr double kAwake = 1e-4;       // [s] longest busy wait for one request
constexpr double kOthersWork = 2e-5;  // [s] a longer gap means that other processes need the processor
constexpr int kAsleep = 16;  // number of requests to wait for asleep before it tries busy waiting again

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

int codeOf(const Error& error) {
  if (error.code == ErrorCode::kUsage) return kUsage;
  return error.code == ErrorCode::kIo ? kIo : kBadInput;
}

int say(const Error& error) {
  std::fprintf(stderr, "fulbito-team-host: %s\n", error.message.c_str());
  return codeOf(error);
}

/// Input and output of the messages, moved away from the standard descriptors. The team gets an empty
/// standard input, and its standard output goes to standard error.
struct Ends {
  int in = -1;
  int out = -1;
};

Ends moveEnds() {
  const int least = STDERR_FILENO + 1;
  // Affects only this end of the pipe; the simulator has a file description of its own.
  fcntl(STDIN_FILENO, F_SETFL, fcntl(STDIN_FILENO, F_GETFL) | O_NONBLOCK);
  const Ends ends{fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, least), fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, least)};
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  if (nothing > STDERR_FILENO) close(nothing);
  return ends;
}

bool writeAll(int to, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(to, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

/// Sends the simulator the reason why this program ends.
int tell(const Error& error, Ends ends) {
  std::string message;
  const std::string reason = error.message.substr(0, kLongestReason);
  const std::size_t begin = beginFrame(static_cast<std::uint16_t>(FrameKind::kFailed), 0, message);
  message.append(reason.c_str(), std::strlen(reason.c_str()) + 1);
  endFrame(begin, message);
  return writeAll(ends.out, message) ? codeOf(error) : say(error);
}

/// The received messages that are not answered yet.
class Inbox {
 public:
  explicit Inbox(int from) : from_(from), bytes_(kLargestFrame) {}

  /// Waits for more bytes. @return false at the end of the input
  bool receive() {
    const double since = now();
    if (crowded_ > 0) --crowded_;
    for (;;) {
      const ssize_t n = read(from_, bytes_.data() + filled_, bytes_.size() - filled_);
      if (n > 0) filled_ += static_cast<std::size_t>(n);
      if (n >= 0) return n > 0;
      if (errno != EAGAIN && errno != EINTR) return false;
      rest(since);
    }
  }
  std::string_view waiting() const { return {bytes_.data(), filled_}; }
  /// Removes the first `size` bytes. The buffer has room for a whole message, so `receive` never stalls.
  void drop(std::size_t size) {
    filled_ -= size;
    std::memmove(bytes_.data(), bytes_.data() + size, filled_);
  }

 private:
  /// Waits for a short time. It waits busily, because the next request of a fast match arrives sooner than a
  /// sleeping processor wakes up. If other processes need the processor, it sleeps.
  void rest(double since) {
    if (crowded_ == 0 && now() - since < kAwake) {
      const double before = now();
      sched_yield();
      if (now() - before > kOthersWork) crowded_ = kAsleep;
      return;
    }
    pollfd wait{from_, POLLIN, 0};
    poll(&wait, 1, -1);
  }

  int from_;
  std::vector<char> bytes_;
  std::size_t filled_ = 0;
  int crowded_ = 0;  ///< number of requests to wait for asleep
};

/// Answers all complete messages in the inbox, and removes them.
Result<void> answerAll(TeamHost& host, Inbox& inbox, std::string& replies) {
  std::size_t done = 0;
  for (;;) {
    const std::string_view rest = inbox.waiting().substr(done);
    const auto length = frameLength(rest);
    if (!length) return tl::unexpected<Error>(length.error());
    if (*length == 0) break;
    if (auto answered = host.answer(rest.substr(0, *length), replies); !answered) return answered;
    done += *length;
  }
  inbox.drop(done);
  return {};
}

int serve(TeamHost& host, Ends ends) {
  Inbox inbox(ends.in);
  std::string replies;
  while (inbox.receive()) {
    replies.clear();
    if (const auto done = answerAll(host, inbox, replies); !done) return tell(done.error(), ends);
    if (!writeAll(ends.out, replies)) return 0;  // the simulator has ended the match
  }
  return 0;
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    return say(
        {ErrorCode::kUsage, "usage: fulbito-team-host LIBRARY [name=value ...], as a child of fulbito"});
  }
  std::vector<Setting> settings;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::size_t equals = arguments[i].find('=');
    if (equals == std::string::npos || equals == 0) {
      return say({ErrorCode::kUsage, "'" + arguments[i] + "' is not of the form name=value"});
    }
    settings.push_back({arguments[i].substr(0, equals), arguments[i].substr(equals + 1)});
  }
  const Ends ends = moveEnds();
  if (ends.in < 0 || ends.out < 0) return say({ErrorCode::kIo, "standard input or output is closed"});
  const auto library = TeamLibrary::open(arguments.front());
  if (!library) return tell(library.error(), ends);
  TeamHost host(*library, std::move(settings), {});
  return serve(host, ends);
}

}  // namespace
}  // namespace fulbito

int main(int count, char** arguments) {
  return fulbito::run(std::vector<std::string>(arguments + 1, arguments + count));
}
