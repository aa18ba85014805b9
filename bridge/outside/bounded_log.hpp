#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace fulbito {

/// Where the standard error of a team's program goes: one line at a time, without its end.
using TeamLog = std::function<void(std::string_view line)>;

/// A team's standard error during one match: the first part of it, and how much followed.
class BoundedLog {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 20;  ///< [bytes] with the ends of the lines

  /// @param log  takes the lines; empty: they are dropped
  explicit BoundedLog(TeamLog log) : log_(std::move(log)) {}
  BoundedLog(const BoundedLog&) = delete;
  BoundedLog& operator=(const BoundedLog&) = delete;
  ~BoundedLog() { finish(); }

  void add(std::string_view line);
  /// Says how much was left out, if anything was, and starts anew.
  void finish();

 private:
  TeamLog log_;
  std::size_t shown_ = 0;     // [bytes]
  std::size_t left_out_ = 0;  // [bytes]
};

}  // namespace fulbito
