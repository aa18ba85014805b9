#pragma once

#include <cstdint>

#include "fulbito/match.hpp"

namespace fulbito::app {

/// A live status line on stderr: score, clock, speed. Silent if stderr is not a terminal.
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
