#pragma once

#include <string>
#include <vector>

namespace fulbito::test {

/// What a line of text cites that a reader of this repository cannot look up: page names, phrases and
/// numbers of documents that are not in it. Words of the line, in order; pages (*.md) are not among them.
std::vector<std::string> privateCitationsIn(const std::string& line);

/// Pages (words that end in .md) that a line of text names, as they are written there.
std::vector<std::string> pagesNamedIn(const std::string& line);

}  // namespace fulbito::test
