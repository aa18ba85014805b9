#include <csignal>
#include <fcntl.h>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {
namespace {

void loop(const Scene&) {
  volatile unsigned turns = 0;
  for (;;) turns = turns + 1;
}

void readOn(const Scene&) {
  char bytes[4096];
  while (::read(STDIN_FILENO, bytes, sizeof bytes) > 0) {
  }
  waitForEver();
}

void ignoreSignals(const Scene& scene) {
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_IGN);
  loop(scene);
}

void closeBoth(const Scene&) {
  ::close(STDIN_FILENO);
  ::close(STDOUT_FILENO);
  waitForEver();
}

constexpr Kind kSilences[] = {
    {"endless-loop", "computes for ever", loop},
    {"sleep", "sleeps for ever", [](const Scene&) { waitForEver(); }},
    {"silence", "reads on and never answers", readOn},
    {"ignore-signals", "ignores all signals and computes for ever", ignoreSignals},
    {"stop-itself", "stops itself", [](const Scene&) { ::raise(SIGSTOP); }},
    {"close-pipes", "closes both pipes and stays", closeBoth},
    {"close-input", "closes its input and stays",
     [](const Scene&) {
       ::close(STDIN_FILENO);
       waitForEver();
     }},
    {"close-output", "closes its output and stays",
     [](const Scene&) {
       ::close(STDOUT_FILENO);
       waitForEver();
     }},
    {"slow-start", "is not ready for an hour", [](const Scene&) { ::sleep(3600); }},
};

}  // namespace

std::span<const Kind> silences() { return kSilences; }

}  // namespace fulbito::test
