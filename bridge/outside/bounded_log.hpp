#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace fulbito {

/// Receives the standard error of a team's program: one line at a time, without its end.
using TeamLog = std::function<void(std::string_view line)>;

/// What a team's program prints for people during one match: passes the first part on and counts the rest.
class BoundedLog {
 public:
  /// [bytes] passed on, with the ends of the lines
  static constexpr std::size_t kMost = std::size_t{1} << 20;

  /// @param log  takes the lines; empty: they are dropped
  explicit BoundedLog(TeamLog log) : log_(std::move(log)) {}
  BoundedLog(const BoundedLog&) = delete;
  BoundedLog& operator=(const BoundedLog&) = delete;
  ~BoundedLog() { finish(); }

  void add(std::string_view line);
  /// Adds the whole lines of a text and removes them from it. @param all  the rest too, as a line
  void addLines(std::string& text, bool all);
  /// Reports the number of bytes that were left out, if any, and starts anew.
  void finish();

 private:
  TeamLog log_;
  std::size_t shown_ = 0;     // [bytes]
  std::size_t left_out_ = 0;  // [bytes]
};

}  // namespace fulbito
