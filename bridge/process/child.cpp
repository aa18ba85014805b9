#include "bridge/process/child.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <poll.h>
#include <sched.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "bridge/process/errors_kept.hpp"
#include "bridge/process/launch.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostWaiting = std::size_t{1} << 24;  // [bytes]
constexpr std::size_t kReadAtOnce = 65536;                  // [bytes] capacity of a pipe
// reads at once: a flood of errors must not hold up the caller
constexpr int kErrorReads = 16;
constexpr std::size_t kMostErrors = std::size_t{1} << 22;  // [bytes] per wait; then the child's writes block

/// Writing into a pipe without a reader raises SIGPIPE in this thread. The program that uses the library must
/// not get it, and the library must not change that program's handling of signals.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  ~NoPipeSignal() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  /// Takes the signal that a write has raised, unless the program itself had blocked it.
  void swallow() const {
    if (sigismember(&before_, SIGPIPE) != 0) return;
    const timespec now{};
    while (::sigtimedwait(&pipe_, nullptr, &now) < 0 && errno == EINTR) {
    }
  }

 private:
  sigset_t pipe_{};
  sigset_t before_{};
};

timespec timeOf(double seconds) {
  constexpr double kLongest = 1e9;  // [s] 30 years
  // NaN fails the comparison and becomes 0: no wait.
  const double time = seconds > 0.0 ? std::min(seconds, kLongest) : 0.0;
  const double whole = std::floor(time);
  return {static_cast<time_t>(whole), static_cast<long>((time - whole) * 1e9)};
}

constexpr int kYields = 50;  // some tens of microseconds

/// Polls and subtracts the elapsed time from `left`: the system call does so, the C library's function does
/// not.
int pollFor(pollfd* waits, nfds_t count, timespec& left) {
  return static_cast<int>(::syscall(SYS_ppoll, waits, count, &left, nullptr, 0));
}

std::string statusText(int status) {
  if (WIFEXITED(status)) return fmt::format("exit code {}", WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  const char* name = ::sigdescr_np(signal);
  return fmt::format("signal {} ({})", signal, name == nullptr ? "unknown" : name);
}

}  // namespace

struct Child::Impl {
  Impl() : buffer(kReadAtOnce, '\0') {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { end(); }
  void take(Launched&& started);

  /// Sends the waiting bytes, as far as the pipe takes them.
  bool flush();
  /// Returns how many bytes it has read.
  std::size_t drainErrors();
  Received readOutput(std::string& into);
  void stop();
  ChildEnd end();
  ChildEnd howItEnded(int keeper_status) const;
  /// Ends the conversation for a reason of errno that is not the child's fault.
  void machineFailed(const char* what);

  SharedPage page;
  pid_t keeper = -1;     ///< -1: none, or it has ended
  bool stopped = false;  ///< asked to end
  bool broken = false;   ///< the child has closed `in`
  Descriptor in, out, errors;
  std::vector<Descriptor> sockets;
  std::string waiting;   ///< bytes that wait for `in`
  std::size_t sent = 0;  ///< bytes of `waiting` that were sent
  ErrorsKept errors_kept;
  std::string buffer;   ///< for reads from the pipes
  std::string failure;  ///< what failed on the machine; empty: nothing
  ChildEnd ended;       ///< how the child ended; without a reason while it runs
  Containment containment;
};

void Child::Impl::take(Launched&& started) {
  page = std::move(started.page);
  keeper = started.keeper;
  in = std::move(started.in);
  out = std::move(started.out);
  errors = std::move(started.errors);
  sockets = std::move(started.sockets);
  containment.layers = linesOf(page->layers.view());
  containment.missing = linesOf(page->missing.view());
}

bool Child::Impl::flush() {
  if (!in.isOpen()) return false;
  const NoPipeSignal quiet;
  while (sent < waiting.size()) {
    const ssize_t wrote = ::write(in.number(), waiting.data() + sent, waiting.size() - sent);
    if (wrote >= 0) {
      sent += static_cast<std::size_t>(wrote);
    } else if (errno == EAGAIN) {
      return true;
    } else if (errno != EINTR) {
      if (errno == EPIPE) {
        quiet.swallow();
        broken = true;
      } else {
        machineFailed("write to it");
      }
      in.close();
      return false;
    }
  }
  waiting.clear();
  sent = 0;
  return true;
}

std::size_t Child::Impl::drainErrors() {
  std::size_t bytes = 0;
  for (int round = 0; round < kErrorReads && errors.isOpen(); ++round) {
    const ssize_t got = ::read(errors.number(), buffer.data(), buffer.size());
    if (got > 0) {
      errors_kept.add({buffer.data(), static_cast<std::size_t>(got)});
      bytes += static_cast<std::size_t>(got);
    } else if (got == 0 || errno != EINTR) {
      if (got == 0 || errno != EAGAIN) errors.close();
      break;
    }
  }
  return bytes;
}

Child::Received Child::Impl::readOutput(std::string& into) {
  for (;;) {
    const ssize_t got = ::read(out.number(), buffer.data(), buffer.size());
    if (got > 0) {
      into.append(buffer.data(), static_cast<std::size_t>(got));
      return Received::kBytes;
    }
    if (got < 0 && errno == EAGAIN) return Received::kNothing;
    if (got == 0 || errno != EINTR) {
      if (got < 0) machineFailed("read from it");
      out.close();
      return Received::kClosed;
    }
  }
}

void Child::Impl::machineFailed(const char* what) {
  if (failure.empty()) failure = fmt::format("cannot {}: {}", what, std::strerror(errno));
}

/// A team can reach neither its keeper nor the first process of its namespace, so it is not at fault if they
/// are killed.
ChildEnd Child::Impl::howItEnded(int keeper_status) const {
  if (!failure.empty()) return {failure, true};
  if (const std::string_view reason = page->reason.view(); !reason.empty()) {
    return {std::string(reason), page->machine_failed};
  }
  if (page->ended) return {statusText(page->wait_status), false};
  if (keeper_status == 0) return {kKilled, false};
  return {fmt::format("its keeper ended: {}", statusText(keeper_status)), true};
}

void Child::Impl::stop() {
  if (keeper < 0 || stopped) return;
  stopped = true;
  page->pipe_closed = broken || !out.isOpen();
  ::kill(keeper, SIGTERM);
  ::kill(keeper, SIGCONT);  // wakes it if it was stopped
}

ChildEnd Child::Impl::end() {
  if (keeper < 0) return ended;
  stop();
  const int keeper_status = waitForKeeper(keeper);
  keeper = -1;
  drainErrors();
  in.close();
  out.close();
  errors.close();
  removeLeftovers(*page);
  return ended = howItEnded(keeper_status);
}

Child::Child(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Child::Child(Child&&) noexcept = default;
Child& Child::operator=(Child&&) noexcept = default;
Child::~Child() = default;

Result<Child> Child::launch(const ChildOptions& options) {
  auto child = std::make_unique<Impl>();  // allocated first: nothing may fail once a child has started
  Result<Launched> started = launchTeam(options);
  if (!started) return tl::unexpected<Error>(started.error());
  child->take(std::move(*started));
  return Child(std::move(child));
}

bool Child::send(std::string_view bytes) {
  Impl& child = *impl_;
  if (!child.in.isOpen()) return false;
  if (child.waiting.size() - child.sent + bytes.size() > kMostWaiting) return false;
  if (child.sent > child.waiting.size() / 2) {
    child.waiting.erase(0, child.sent);
    child.sent = 0;
  }
  child.waiting.append(bytes);
  return child.flush();
}

Child::Received Child::receive(std::string& into, double seconds) {
  Impl& child = *impl_;
  timespec left = timeOf(seconds);
  // A quick reply arrives sooner than a sleeping processor wakes up. Yielding lets the child run on this
  // processor.
  for (int round = 0; child.out.isOpen(); ++round) {
    if (const Received got = child.readOutput(into); got != Received::kNothing) return got;
    if (!(seconds > 0.0) || round == kYields) break;
    ::sched_yield();
  }
  if (child.out.isOpen() && !(seconds > 0.0) && child.sent == child.waiting.size()) return Received::kNothing;
  // The system subtracts only the time asleep from `left`. Reading errors takes time too: the bound keeps it
  // short.
  for (std::size_t errors = 0;;) {
    if (!child.out.isOpen()) return Received::kClosed;
    std::array<pollfd, 3> waits{{{child.out.number(), POLLIN, 0},
                                 {errors < kMostErrors ? child.errors.number() : -1, POLLIN, 0},
                                 {child.sent < child.waiting.size() ? child.in.number() : -1, POLLOUT, 0}}};
    const int ready = pollFor(waits.data(), waits.size(), left);
    if (ready < 0 && errno != EINTR) {
      child.machineFailed("wait for it");
      return Received::kClosed;
    }
    if (ready == 0) return Received::kNothing;
    if (ready < 0) continue;
    if (waits[1].revents != 0) errors += child.drainErrors();
    if (waits[2].revents != 0) child.flush();
    if (waits[0].revents != 0) {
      if (const Received got = child.readOutput(into); got != Received::kNothing) return got;
    }
  }
}

void Child::closeInput() { impl_->in.close(); }

std::string Child::takeErrors() {
  impl_->drainErrors();
  return impl_->errors_kept.take();
}

void Child::stop() { impl_->stop(); }

ChildEnd Child::end() { return impl_->end(); }

std::vector<Descriptor> Child::takeSockets() { return std::exchange(impl_->sockets, {}); }

const Containment& Child::containment() const { return impl_->containment; }

}  // namespace fulbito
