#include "engine/core/config/suggest.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace fulbito {
namespace {

// Longer words are not typing errors, and the comparison's time grows with the length.
constexpr std::size_t kLongestWord = 64;

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  if (word.empty() || word.size() > kLongestWord) return {};
  const std::string typed = lowered(word);
  const std::string* best = nullptr;
  std::size_t best_distance = (word.size() + 2) / 3 + 1;
  for (const std::string& candidate : candidates) {
    const std::string known = lowered(candidate);
    const bool prefix = typed.size() >= 2 && known.starts_with(typed);
    const std::size_t d = prefix ? 1 : editDistance(typed, known);
    if (d < best_distance) best_distance = d, best = &candidate;
  }
  return best == nullptr ? std::string() : " Did you mean '" + *best + "'?";
}

}  // namespace fulbito
