#include <algorithm>

#include <fmt/format.h>

#include "tournament/report/grid.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

constexpr int kGap = 2;
// Names shrink to the first width before an optional column is dropped, and to the second only after that.
constexpr int kLeastFlexible = 16;
constexpr int kLeastOfAll = 6;

/// The column widths of a table, chosen so that it fits; 0: the column is left out.
class Widths {
 public:
  explicit Widths(const Grid& grid) : grid_(grid) {
    for (std::size_t c = 0; c < grid.columns.size(); ++c) widths_.push_back(widest(c));
    while (total() > kTextColumns && (total() - slack() > kTextColumns ? dropOne() : shrinkOne())) {
    }
  }
  int operator[](std::size_t column) const { return widths_[column]; }

 private:
  int widest(std::size_t column) const {
    int width = std::max(1, columnsOf(grid_.columns[column].head));
    for (const auto& row : grid_.rows) width = std::max(width, columnsOf(row[column].text));
    return width;
  }
  int total() const {
    int sum = 0;
    for (const int width : widths_) sum += width > 0 ? kGap + width : 0;
    return sum;
  }
  int slackOf(std::size_t column) const {
    return grid_.columns[column].flexible ? std::max(0, widths_[column] - least_) : 0;
  }
  int slack() const {
    int sum = 0;
    for (std::size_t c = 0; c < widths_.size(); ++c) sum += slackOf(c);
    return sum;
  }
  /// Leaves out the last optional column, or else lets names shrink further. False if neither is possible.
  bool dropOne() {
    for (std::size_t c = widths_.size(); c-- > 0;) {
      if (!grid_.columns[c].optional || widths_[c] == 0) continue;
      widths_[c] = 0;
      return true;
    }
    least_ = kLeastOfAll;
    return shrinkOne();
  }
  /// Narrows the widest flexible column by one. False if no column can be narrower.
  bool shrinkOne() {
    std::size_t best = 0;
    for (std::size_t c = 1; c < widths_.size(); ++c) best = slackOf(c) > slackOf(best) ? c : best;
    if (widths_.empty() || slackOf(best) == 0) return false;
    --widths_[best];
    return true;
  }

  const Grid& grid_;
  std::vector<int> widths_;
  int least_ = kLeastFlexible;
};

std::string lineOf(const Grid& grid, const Widths& widths, const auto& text_of) {
  std::string line;
  for (std::size_t c = 0; c < grid.columns.size(); ++c) {
    if (widths[c] == 0) continue;
    line +=
        std::string(kGap, ' ') + padded(shownText(text_of(c), widths[c]), widths[c], grid.columns[c].number);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

}  // namespace

std::string textOf(const Grid& grid) {
  const Widths widths(grid);
  std::string text = grid.title + '\n';
  text += lineOf(grid, widths, [&](std::size_t c) -> const std::string& { return grid.columns[c].head; });
  for (const auto& row : grid.rows) {
    text += lineOf(grid, widths, [&](std::size_t c) -> const std::string& { return row[c].text; });
  }
  return grid.note.empty() ? text : text + "  " + grid.note + '\n';
}

}  // namespace fulbito
