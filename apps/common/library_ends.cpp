#include "apps/common/library_ends.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/syscall.h>
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
int code_of_main = 0;
pid_t this_process = 0;

void write(const char* words) {
  if (::write(STDERR_FILENO, words, std::strlen(words)) < 0) return;
}

/// Writes one line to stderr with calls that are allowed in signal handlers. If a thread of the library ends
/// the program, the line cannot name the library.
void sayHow(const char* how) {
  const char* library = libraryOfThisThread();
  write(library != nullptr ? "fulbito: the library '" : "fulbito: a library");
  if (library != nullptr) write(library);
  write(library != nullptr ? "' ends this program: " : " ends this program: ");
  write(how);
  write(kAdvice);
}

[[noreturn]] void endByLibrary(const char* how) {
  std::fflush(stdout);
  abandonUnfinishedWork();
  sayHow(how);
  endProcess(kTeamFailed);
}

void onExit() {
  if (!main_is_over) endByLibrary("it calls exit");
}

/// This program itself calls `endProcess`. So only a library, or a child process that it forked, gets here.
[[noreturn]] void onHardExit(int code) {
  if (this_process == 0 || ::getpid() != this_process) endProcess(code);
  if (main_is_over) endProcess(code_of_main);
  endByLibrary("it calls _exit");
}

void onCrash(int signal) {
  // The handler is already reset (SA_RESETHAND), so the signal ends the process.
  for (const Crash& crash : kCrashes) {
    if (crash.signal == signal && libraryOfThisThread() != nullptr) {
      abandonUnfinishedWork();
      sayHow(crash.what);
    }
  }
  ::raise(signal);
}

}  // namespace

void endProcess(int code) {
  for (;;) ::syscall(SYS_exit_group, code);
}

void watchLibraries() {
  this_process = ::getpid();
  std::atexit(onExit);
  std::at_quick_exit(onExit);
  for (const Crash& crash : kCrashes) {
    struct sigaction before{};
    ::sigaction(crash.signal, nullptr, &before);
    if (before.sa_handler != SIG_DFL) continue;  // sanitizers install their own handlers
    struct sigaction action{};
    action.sa_handler = onCrash;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    ::sigaction(crash.signal, &action, nullptr);
  }
}

void endOfMain(int code) {
  code_of_main = code;
  main_is_over = true;
}

}  // namespace fulbito::app

// The dynamic linker finds these before those of the C library. The C library offers no hook for such calls.
extern "C" {
void _exit(int code) { fulbito::app::onHardExit(code); }
void _Exit(int code) { fulbito::app::onHardExit(code); }  // NOLINT(bugprone-reserved-identifier)
}
