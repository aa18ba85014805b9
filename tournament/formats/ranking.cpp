#include "tournament/formats/ranking.hpp"

#include <algorithm>
#include <string>

namespace fulbito {
namespace {

/// The first criterion in which the lines differ, or null.
const Criterion* separating(const Standing& a, const Standing& b, std::span<const Criterion> criteria) {
  const auto found = std::find_if(criteria.begin(), criteria.end(), [&](const Criterion& criterion) {
    return criterion.values[a.entrant] != criterion.values[b.entrant];
  });
  return found == criteria.end() ? nullptr : &*found;
}

bool isBefore(const Standing& a, const Standing& b, std::span<const Criterion> criteria) {
  const Criterion* by = separating(a, b, criteria);
  return by ? by->values[a.entrant] > by->values[b.entrant] : a.entrant < b.entrant;
}

}  // namespace

std::vector<std::span<Standing>> sortBy(std::span<Standing> lines, std::span<const Criterion> criteria) {
  std::string first = lines.empty() ? "" : lines.front().decided_by;
  std::sort(lines.begin(), lines.end(),
            [&](const Standing& a, const Standing& b) { return isBefore(a, b, criteria); });
  std::vector<std::span<Standing>> blocks;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= lines.size(); ++i) {
    const Criterion* by = i < lines.size() ? separating(lines[i - 1], lines[i], criteria) : nullptr;
    if (i < lines.size()) lines[i].decided_by = by ? by->name : "";
    if (i < lines.size() && !by) continue;
    if (i - begin > 1) blocks.push_back(lines.subspan(begin, i - begin));
    begin = i;
  }
  if (!lines.empty()) lines.front().decided_by = std::move(first);
  return blocks;
}

void giveRanks(std::span<Standing> lines, std::string_view silent) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool shared = i > 0 && lines[i].decided_by.empty();
    lines[i].rank = shared ? lines[i - 1].rank : static_cast<int>(i) + 1;
  }
  for (Standing& line : lines) {
    if (line.decided_by == silent) line.decided_by.clear();
  }
}

std::vector<Standing> ranked(std::vector<Standing> table, std::span<const Criterion> criteria,
                             std::string_view silent) {
  sortBy(table, criteria);
  giveRanks(table, silent);
  return table;
}

}  // namespace fulbito
