#include "apps/common/library_ends.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

#include "apps/common/commands.hpp"
#include "engine/core/system/unfinished_work.hpp"
#include "navigation/library/plugin_library.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kAdvice = "; --isolate process contains teams\n";

struct Crash {
  int signal;
  const char* what;
};
constexpr std::array<Crash, 5> kCrashes{{{SIGSEGV, "signal 11 (Segmentation fault)"},
                                         {SIGABRT, "signal 6 (Aborted)"},
                                         {SIGBUS, "signal 7 (Bus error)"},
                                         {SIGFPE, "signal 8 (Arithmetic exception)"},
                                         {SIGILL, "signal 4 (Illegal instruction)"}}};

bool main_is_over = false;

void write(const char* words) {
  if (::write(STDERR_FILENO, words, std::strlen(words)) < 0) return;
}

/// One line on standard error, by calls that are allowed in a handler of signals. The library is unknown
/// where a thread of its own ends the program.
void sayHow(const char* how) {
  const char* library = libraryOfThisThread();
  write(library != nullptr ? "fulbito: the library '" : "fulbito: a library");
  if (library != nullptr) write(library);
  write(library != nullptr ? "' ends this program: " : " ends this program: ");
  write(how);
  write(kAdvice);
}

void onExit() {
  if (main_is_over) return;
  std::fflush(stdout);
  abandonUnfinishedWork();
  sayHow("it calls exit");
  ::_exit(kTeamFailed);
}

void onCrash(int signal) {
  // The handler is gone by now (SA_RESETHAND), so that the signal ends the process.
  for (const Crash& crash : kCrashes) {
    if (crash.signal == signal && libraryOfThisThread() != nullptr) {
      abandonUnfinishedWork();
      sayHow(crash.what);
    }
  }
  ::raise(signal);
}

}  // namespace

void watchLibraries() {
  std::atexit(onExit);
  std::at_quick_exit(onExit);
  for (const Crash& crash : kCrashes) {
    struct sigaction before{};
    ::sigaction(crash.signal, nullptr, &before);
    if (before.sa_handler != SIG_DFL) continue;  // sanitizers have their own
    struct sigaction action{};
    action.sa_handler = onCrash;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    ::sigaction(crash.signal, &action, nullptr);
  }
}

void endOfMain() { main_is_over = true; }

}  // namespace fulbito::app
