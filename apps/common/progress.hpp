#pragma once

#include <cstdint>
#include <string>

namespace fulbito::app {

/// Progress on stderr: on a terminal a bar with the remaining time, otherwise a plain line every ten seconds.
/// Prints nothing if `quiet`.
class ProgressBar {
 public:
  explicit ProgressBar(const std::string& what, bool quiet = false);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Shows the progress. Returns whether to continue (false after a signal).
  bool update(std::size_t done, std::size_t total);

 private:
  void draw(std::size_t done, std::size_t total, double elapsed) const;

  std::string what_;
  bool quiet_;
  bool terminal_;
  std::int64_t begin_;
  std::int64_t last_;
  bool drawn_ = false;
};

}  // namespace fulbito::app
