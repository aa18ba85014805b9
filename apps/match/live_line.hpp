#pragma once

#include <cstdint>

#include "fulbito/match.hpp"

namespace fulbito::app {

/// A status line on stderr with score, clock and speed. Prints nothing if stderr is not a terminal.
class LiveLine {
 public:
  explicit LiveLine(const MatchConfig& config);
  ~LiveLine();
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;
  /// Redraws at most every 0.1 s.
  void update(const Match& match);

 private:
  const MatchConfig& config_;
  bool terminal_;
  std::int64_t begin_;
  std::int64_t last_;
  bool drawn_ = false;
};

}  // namespace fulbito::app
