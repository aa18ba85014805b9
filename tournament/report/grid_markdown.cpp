#include <fmt/format.h>

#include "engine/core/base/text_controls.hpp"
#include "tournament/report/grid.hpp"

namespace fulbito {
namespace {

std::string rowOf(const std::vector<GridCell>& cells) {
  std::string line = "|";
  for (const GridCell& cell : cells) line += ' ' + escapedMarkdown(cell.text) + " |";
  return line + '\n';
}

std::string headOf(const Grid& grid) {
  std::string names = "|", rule = "|";
  for (const GridColumn& column : grid.columns) {
    names += ' ' + escapedMarkdown(column.head) + " |";
    rule += column.number ? "---:|" : "---|";
  }
  return names + '\n' + rule + '\n';
}

}  // namespace

std::string escapedMarkdown(std::string_view text) {
  std::string out;
  for (const char c : oneLine(text)) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      if (std::string_view("\\`*_{}[]#|~:@!>$").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
  }
  return out;
}

std::string markdownOf(const Grid& grid, std::size_t bytes) {
  std::string text = "### " + escapedMarkdown(grid.title) + "\n\n" + headOf(grid);
  std::size_t shown = 0;
  for (; shown < grid.rows.size(); ++shown) {
    const std::string line = rowOf(grid.rows[shown]);
    constexpr std::size_t kNoteBytes = 1024;
    if (text.size() + line.size() + kNoteBytes > bytes) break;
    text += line;
  }
  if (shown < grid.rows.size())
    text += fmt::format("\n{} more rows do not fit here.\n", grid.rows.size() - shown);
  if (!grid.note.empty()) text += '\n' + escapedMarkdown(grid.note) + '\n';
  return text + '\n';
}

}  // namespace fulbito
