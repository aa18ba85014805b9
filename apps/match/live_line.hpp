#pragma once

#include <cstdint>

#include "match/play/match.hpp"

namespace fulbito::app {

/// One line on stderr that follows a match: score, clock, speed. Silent where stderr is no terminal.
class LiveLine {
 public:
  explicit LiveLine(const MatchConfig& config);
  ~LiveLine();
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;
  /// Redraws when it is time to.
  void update(const Match& match);

 private:
  const MatchConfig& config_;
  bool terminal_;
  std::int64_t begin_;
  std::int64_t last_;
  bool drawn_ = false;
};

}  // namespace fulbito::app
