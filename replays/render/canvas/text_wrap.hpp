#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// `utf8` in lines of at most `width` [px], broken after blanks, commas, colons and hyphens, inside a word
/// only where it alone is too wide. No text is left out. At least one line, empty for an empty text.
std::vector<std::string> wrapped(const Canvas& canvas, const std::string& utf8, double size, double width);

}  // namespace fulbito
