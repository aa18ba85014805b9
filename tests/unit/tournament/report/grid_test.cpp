#include "tournament/report/grid.hpp"

#include <sstream>

#include "tests/support/catch.hpp"
#include "tournament/report/shown_text.hpp"

using namespace fulbito;

namespace {

Grid gridOf(const std::string& name, const std::string& more) {
  return {"Title",
          {{"#", true}, {"team", false, true}, {"sum", true}, {"more", false, true, true}},
          {{{"1", {}, {}, {}}, {name, {}, {}, {}}, {"25", {}, {}, {}}, {more, {}, {}, {}}},
           {{"2", {}, {}, {}}, {"b", {}, {}, {}}, {"7", {}, {}, {}}, {"", {}, {}, {}}}},
          "A note."};
}

int widestLine(const std::string& text) {
  std::istringstream lines(text);
  int widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, columnsOf(line));
  return widest;
}

}  // namespace

TEST_CASE("a table in text has its columns in line", "[unit]") {
  CHECK(textOf(gridOf("alpha", "x")) ==
        "Title\n"
        "  #  team   sum  more\n"
        "  1  alpha   25  x\n"
        "  2  b        7\n"
        "  A note.\n");
}

TEST_CASE("a wide table shortens names, then leaves out what is optional", "[unit]") {
  const std::string shortened = textOf(gridOf(std::string(150, 'x'), "y"));
  CHECK(widestLine(shortened) == kTextColumns);
  CHECK(shortened.find("x…") != std::string::npos);
  CHECK(shortened.find("more") != std::string::npos);

  Grid wide = gridOf("alpha", "z");
  for (int i = 0; i < 20; ++i) {
    wide.columns.insert(wide.columns.begin() + 2, {"c", true});
    for (auto& row : wide.rows) row.insert(row.begin() + 2, {"12", {}, {}, {}});
  }
  const std::string dropped = textOf(wide);
  CHECK(widestLine(dropped) <= kTextColumns);
  CHECK(dropped.find("more") == std::string::npos);
  CHECK(dropped.find("alpha") != std::string::npos);
}

TEST_CASE("Markdown escapes what would be markup", "[unit]") {
  CHECK(escapedMarkdown("a|b <i> *c* [d](e) `f` #1 @g &amp;") ==
        "a\\|b &lt;i\\> \\*c\\* \\[d\\](e) \\`f\\` \\#1 \\@g &amp;amp;");
  CHECK(markdownOf(gridOf("al|pha", "x"), 4096) ==
        "### Title\n\n| \\# | team | sum | more |\n|---:|---|---:|---|\n| 1 | al\\|pha | 25 | x |\n"
        "| 2 | b | 7 |  |\n\nA note.\n\n");
}

TEST_CASE("a Markdown table keeps to its room and counts what it leaves out", "[unit]") {
  Grid grid = gridOf("alpha", "x");
  for (int i = 0; i < 1000; ++i) grid.rows.push_back(grid.rows[0]);
  const std::string text = markdownOf(grid, 4096);
  CHECK(text.size() <= 4096);
  std::size_t rows = 0;
  for (std::size_t at = text.find("\n| 1 |"); at != std::string::npos; at = text.find("\n| 1 |", at + 1))
    ++rows;
  rows += 1;  // the second one
  CHECK(text.find(std::to_string(1002 - rows) + " more rows do not fit here.") != std::string::npos);
}
