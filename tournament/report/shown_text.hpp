#pragma once

#include <string>
#include <string_view>

namespace fulbito {

/// Columns that UTF-8 text takes on a terminal, after M. Kuhn's wcwidth: 2 for wide East Asian characters
/// and emoji. Combining marks count 1 here, so that no text is longer than it seems.
int columnsOf(std::string_view utf8);

/// Text of any origin as one line of at most `columns` columns. Control characters, line ends and invalid
/// bytes become spaces; invisible characters and direction marks are removed. A text that does not fit ends
/// with "…".
std::string shownText(std::string_view text, int columns);

/// `text` padded with spaces to `columns`; `before`: the spaces come before the text.
std::string padded(const std::string& text, int columns, bool before);

}  // namespace fulbito
