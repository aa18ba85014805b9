#include "apps/common/console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <string>
#include <system_error>
#include <unistd.h>

#include "apps/common/commands.hpp"
#include "engine/core/system/error_text.hpp"

namespace fulbito::app {
namespace {

/// errno of the first failed write to stdout; empty if none failed.
std::optional<int> lost;

void look(bool written) {
  if (!written && !lost) lost = errno;
}

}  // namespace

void openStandardDescriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // `open` returns the lowest free descriptor, which is this one. Writing to a read-only descriptor fails,
    // as it should.
    const int opened = ::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY);
    if (opened != descriptor) return;
  }
}

void writeOut(std::string_view text) {
  if (!lost) look(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void printOut(std::string_view text) { writeOut(terminalText(text)); }

void printNote(std::string_view text) { std::fputs(terminalText(text).c_str(), stderr); }

void flushOut() { look(std::fflush(stdout) == 0); }

bool drawsLines() {
  const char* const terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

int finishOutput(int code) {
  flushOut();
  if (!lost && std::ferror(stdout) != 0) lost = 0;  // CLI11 writes --help with its own calls
  if (!lost || code > kInterruptedBase) return code;
  if (*lost == EPIPE) return kIo;
  const std::string why = *lost != 0 ? ": " + std::generic_category().message(*lost) : "";
  note("fulbito: cannot write to stdout{}\n", why);
  return kIo;
}

}  // namespace fulbito::app
