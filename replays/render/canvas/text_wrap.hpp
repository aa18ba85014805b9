#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Breaks `utf8` into lines of at most `width` [px], after blanks, commas, colons and hyphens. A word is only
/// broken if it is wider than a line. No text is left out. Returns at least one line, which is empty for an
/// empty text.
std::vector<std::string> wrapped(const Canvas& canvas, const std::string& utf8, double size, double width);

}  // namespace fulbito
