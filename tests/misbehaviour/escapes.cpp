#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {
namespace {

constexpr unsigned kMostSeconds = 60;  // [s] for the day when containment fails

void stayBehind() {
  ::prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0);
  ::alarm(kMostSeconds);
  waitForEver();
}

/// A child of a child in a session of its own, without the pipes.
void leaveDaemon() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    if (::fork() == 0) {
      for (int descriptor = 0; descriptor < 3; ++descriptor) ::close(descriptor);
      stayBehind();
    }
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
}

void daemon(const Scene&) {
  leaveDaemon();
  ::_exit(0);
}

void daemonAndStay(const Scene&) {
  leaveDaemon();
  waitForEver();
}

/// The child keeps the pipes open in a session of its own.
void newSession(const Scene&) {
  if (::fork() == 0) {
    ::setsid();
    stayBehind();
  }
  ::_exit(0);
}

void forkAndLeave(const Scene&) {
  for (int generation = 0; generation < 30; ++generation) {
    if (::fork() != 0) ::_exit(0);
    ::setsid();
  }
  stayBehind();
}

constexpr Kind kEscapes[] = {
    {"daemon", "leaves a daemon behind and ends", daemon},
    {"daemon-and-stay", "leaves a daemon behind and stays", daemonAndStay},
    {"new-session", "ends; a child in a session of its own holds its pipes", newSession},
    {"fork-and-leave", "goes on as the child of a child of a child", forkAndLeave},
};

}  // namespace

std::span<const Kind> escapes() { return kEscapes; }

}  // namespace fulbito::test
