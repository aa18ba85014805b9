#pragma once

#include <cstdint>
#include <string>

#include "tournament/runner/runner.hpp"

namespace fulbito::app {

/// Progress of a tournament on stderr: on a terminal one line that is redrawn, otherwise a plain line every
/// ten seconds.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Shows the progress. Returns whether to continue (false after a signal).
  bool update(const RunProgress& progress);

 private:
  std::string what_;
  bool terminal_;
  std::int64_t begin_;
  std::int64_t last_;
  std::size_t begun_ = 0;  // matches that had results at the first update
  bool started_ = false;
  bool drawn_ = false;
};

/// The line without the remaining time: "ladder: 12 of 40 matches, 1 with a failed team, ratio 1.20
/// [--|=====---]".
std::string progressText(const std::string& what, const RunProgress& progress);

/// Remaining time [s], from the pace of `fresh` matches of this run in `elapsed` seconds. With a test, the
/// time until its ratio reaches a bound at the present drift, if that is sooner. Negative: not known yet.
double secondsLeft(const RunProgress& progress, std::size_t fresh, double elapsed);

}  // namespace fulbito::app
