#include "python/environments/numbered_start.hpp"

#include <charconv>

namespace fulbito {
namespace {

std::optional<std::uint64_t> numberIn(std::string_view text) {
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<NumberedStart> readNumberedStart(std::string_view text, std::string_view word,
                                               std::uint64_t seed) {
  constexpr std::string_view kSeed = " of seed ";
  if (!text.starts_with(word) || text.substr(word.size()).substr(0, 1) != " ") return std::nullopt;
  NumberedStart start{text.substr(word.size() + 1), std::nullopt, seed};
  if (const auto at = start.name.find(kSeed); at != std::string_view::npos) {
    const auto given = numberIn(start.name.substr(at + kSeed.size()));
    if (!given) return std::nullopt;
    start.seed = *given;
    start.name = start.name.substr(0, at);
  }
  if (start.name.empty()) return std::nullopt;
  start.number = numberIn(start.name);
  return start;
}

}  // namespace fulbito
