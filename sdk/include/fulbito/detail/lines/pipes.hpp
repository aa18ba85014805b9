// Lines over a program's standard input and output.
#pragma once

#include <array>
#include <cerrno>
#include <cstdio>
#include <string>
#include <string_view>
#include <unistd.h>

namespace fulbito::team::program {

/// Lines from one descriptor, answers to another.
class Pipes {
 public:
  Pipes(int in, int out) : in_(in), out_(out) {}
  /// The next line without its end. @return false at the end of the input
  bool next(std::string_view& line) {
    received_.erase(0, taken_);
    taken_ = 0;
    for (std::size_t looked_at = 0;;) {
      const std::size_t end = received_.find('\n', looked_at);
      if (end != std::string::npos) {
        line = std::string_view(received_).substr(0, end);
        taken_ = end + 1;
        return true;
      }
      looked_at = received_.size();
      if (!receive()) return false;
    }
  }
  /// Writes the whole text. @return false if the reader has closed the pipe
  bool send(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(out_, text.data(), text.size());
      if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
      if (count < 0 && errno != EINTR) return false;
    }
    return true;
  }

 private:
  bool receive() {
    ssize_t count = 0;
    do count = ::read(in_, piece_.data(), piece_.size());
    while (count < 0 && errno == EINTR);
    if (count > 0) received_.append(piece_.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  int in_, out_;
  std::array<char, 65536> piece_;
  std::string received_;
  std::size_t taken_ = 0;  ///< bytes of `received_` up to the end of the last line
};

/// Keeps standard output for the protocol: from here on, the team's own output there goes to standard error.
/// @return the descriptor of the protocol; -1: there is none
inline int takeOutput() {
  const int out = ::dup(STDOUT_FILENO);
  // Output before a crash must not stay in a buffer.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  return ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0 ? -1 : out;
}

}  // namespace fulbito::team::program
