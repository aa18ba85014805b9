#include "bridge/outside/bounded_log.hpp"

#include <utility>

#include <fmt/format.h>

namespace fulbito {

void BoundedLog::add(std::string_view line) {
  if (!log_) return;
  const std::size_t bytes = line.size() + 1;
  if (left_out_ > 0 || bytes > kMost - shown_) {
    left_out_ += bytes;
    return;
  }
  shown_ += bytes;
  log_(line);
}

void BoundedLog::finish() {
  if (left_out_ > 0) log_(fmt::format("[{} more bytes of standard error in this match]", left_out_));
  shown_ = left_out_ = 0;
}

}  // namespace fulbito
