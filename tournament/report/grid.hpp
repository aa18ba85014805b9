#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fulbito {

/// A column of a table for people.
struct GridColumn {
  std::string head;
  bool number = false;    ///< to the right
  bool flexible = false;  ///< a name or sentence, which a narrow table may shorten
  bool optional = false;  ///< a narrow table may leave it out
};

/// A cell of a table for people.
struct GridCell {
  std::string text;             ///< by `shownText`
  std::optional<double> share;  ///< 0 ... 1, for a colour
  std::string hint;             ///< more about it, where there is room
  std::string match;            ///< the text of a `MatchId` that it is about, for a link
};

/// A table for people, whatever it is written in.
struct Grid {
  std::string title;
  std::vector<GridColumn> columns;
  std::vector<std::vector<GridCell>> rows;
  std::string note;  ///< a sentence below it; may be empty
};

/// Columns of a terminal that a table takes at most.
inline constexpr int kTextColumns = 100;

/// The table in text, with its title: columns in line, at most `kTextColumns` wide.
std::string textOf(const Grid& grid);

/// The table in Markdown, with its title, in at most `bytes`; rows that do not fit are counted in a note.
std::string markdownOf(const Grid& grid, std::size_t bytes);

/// Text without a meaning in Markdown or HTML.
std::string escapedMarkdown(std::string_view text);

}  // namespace fulbito
