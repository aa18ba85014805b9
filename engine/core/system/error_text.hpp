#pragma once

#include <string>
#include <string_view>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The error with the file's name in front of its message, unless it is already there.
tl::unexpected<Error> inFile(const std::string& file, Error error);

/// Untrusted text made safe for a terminal: control characters and invalid UTF-8 become \x1b or \u009b. Line
/// ends and tabs stay.
std::string terminalText(std::string_view text);

/// The text, without its middle if it is longer than `most` bytes (at least 100). Never splits a character.
std::string shortened(std::string_view text, std::size_t most);

/// At most the first `most` bytes of a text. Never splits a character.
std::string_view firstBytes(std::string_view text, std::size_t most);

}  // namespace fulbito
