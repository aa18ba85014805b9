#pragma once

#include <string>
#include <string_view>

#include "engine/core/base/result.hpp"

namespace fulbito {

/// The error of what was read from a file: its message begins with the file's name, once.
tl::unexpected<Error> inFile(const std::string& file, Error error);

/// A text that may come from anywhere as it can be shown on a terminal: control characters and what is no
/// UTF-8 stand as \x1b or \u009b. Line ends and tabs stay.
std::string terminalText(std::string_view text);

/// The text with its middle left out, at a whole character, where it is longer than `most` bytes (at least
/// 100).
std::string shortened(std::string_view text, std::size_t most);

/// The first bytes of a text, at most `most`, ending at a whole character.
std::string_view firstBytes(std::string_view text, std::size_t most);

}  // namespace fulbito
