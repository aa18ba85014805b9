#include "bridge/outside/bounded_log.hpp"

#include <utility>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 12;  // [bytes] beyond it, a line is cut

}  // namespace

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

void BoundedLog::addLines(std::string& text, bool all) {
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    add(std::string_view(text).substr(begin, end - begin));
  }
  text.erase(0, begin);
  if (text.empty() || (!all && text.size() <= kLongestLine)) return;
  add(text);
  text.clear();
}

void BoundedLog::finish() {
  if (left_out_ > 0) log_(fmt::format("[{} more bytes of standard error in this match]", left_out_));
  shown_ = left_out_ = 0;
}

}  // namespace fulbito
