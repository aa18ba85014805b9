#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <string_view>
#include <unistd.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/library_ends.hpp"
#include "engine/core/system/error_text.hpp"
#include "engine/core/system/stop_request.hpp"
#include "engine/core/system/unfinished_work.hpp"

namespace fulbito::app {
namespace {

// [bytes] longest error message, because arguments may have any length.
constexpr std::size_t kMostWords = 2000;
/// Seconds until the process exits after a signal. An alarm each second also ends a wait that began just
/// after the signal.
constexpr int kGrace = 4;

std::atomic<int> first_signal{0};
std::atomic<int> alarms{0};
static_assert(std::atomic<int>::is_always_lock_free);

[[noreturn]] void endNow() {
  abandonUnfinishedWork();
  constexpr std::string_view kWords = "\nfulbito: interrupted\n";
  if (::write(STDERR_FILENO, kWords.data(), kWords.size()) < 0) endProcess(kInterruptedBase + first_signal);
  endProcess(kInterruptedBase + first_signal);
}

void onSignal(int signal) {
  if (signal == SIGALRM) {
    if (++alarms >= kGrace) endNow();
  } else if (first_signal != 0) {
    endNow();
  } else {
    first_signal = signal;
    requestStop();
  }
  ::alarm(1);
}

}  // namespace

int report(const Error& error) {
  note("fulbito: {}\n", shortened(error.message, kMostWords));
  switch (error.code) {
    case ErrorCode::kUsage:
      return kUsage;
    case ErrorCode::kBadInput:
      return kBadInput;
    case ErrorCode::kIo:
      return kIo;
    case ErrorCode::kMachine:
      return kInconclusive;
    case ErrorCode::kInterrupted:
      return interruptedCode();
  }
  return kInternal;
}

std::int64_t now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

bool interrupted() { return stopRequested(); }

int interruptedCode() { return kInterruptedBase + (first_signal != 0 ? first_signal.load() : SIGINT); }

void catchSignals() {
  struct sigaction action{};
  action.sa_handler = onSignal;
  sigfillset(&action.sa_mask);
  // Without SA_RESTART, so that a signal interrupts waits.
  for (const int signal : {SIGINT, SIGTERM, SIGALRM}) ::sigaction(signal, &action, nullptr);
  struct sigaction hang_up{};
  ::sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) ::sigaction(SIGHUP, &action, nullptr);  // nohup ignores this signal
  // With these signals ignored, the write returns an error.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

}  // namespace fulbito::app
