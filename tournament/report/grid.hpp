#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fulbito {

/// A column of a `Grid`.
struct GridColumn {
  std::string head;
  bool number = false;    ///< aligned to the right
  bool flexible = false;  ///< a name or sentence, which may be shortened in a narrow table
  bool optional = false;  ///< may be left out in a narrow table
};

/// A cell of a `Grid`.
struct GridCell {
  std::string text;             ///< made by `shownText`
  std::optional<double> share;  ///< points share 0 ... 1 that colours the cell
  std::string hint;             ///< more details, shown where there is room
  std::string match;  ///< `MatchId` as text if the cell is about a match, for a link to its recording
};

/// A table for people, independent of the output format.
struct Grid {
  std::string title;
  std::vector<GridColumn> columns;
  std::vector<std::vector<GridCell>> rows;
  std::string note;  ///< a sentence below the table; may be empty
};

/// Largest width of a table in a terminal [columns].
inline constexpr int kTextColumns = 100;

/// The table as text with its title: aligned columns, at most `kTextColumns` wide.
std::string textOf(const Grid& grid);

/// The table in Markdown with its title, in at most `bytes` bytes. A note counts the rows that do not fit.
std::string markdownOf(const Grid& grid, std::size_t bytes);

/// The text with all characters escaped that have a meaning in Markdown or HTML.
std::string escapedMarkdown(std::string_view text);

}  // namespace fulbito
