#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

#include "apps/commands.hpp"

namespace fulbito::app {
namespace {

std::atomic<bool> signalled{false};

void onSignal(int signal) {
  signalled = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

int report(const Error& error) {
  std::fprintf(stderr, "fulbito: %s\n", error.message.c_str());
  switch (error.code) {
    case ErrorCode::kUsage:
      return kUsage;
    case ErrorCode::kBadInput:
      return kBadInput;
    case ErrorCode::kIo:
      return kIo;
    case ErrorCode::kInterrupted:
      return kInterrupted;
  }
  return kInternal;
}

std::int64_t now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

bool interrupted() { return signalled; }

void catchSignals() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace fulbito::app
