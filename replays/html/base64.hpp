// Private header of replays/html: not installed.
#pragma once

#include <string>
#include <string_view>

namespace fulbito {

/// RFC 4648, with padding.
std::string base64Of(std::string_view bytes);

/// The bytes that pairs of hexadecimal digits name; stops at anything else.
std::string bytesOfHex(std::string_view digits);

}  // namespace fulbito
