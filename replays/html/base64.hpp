#pragma once

#include <string>
#include <string_view>

namespace fulbito {

/// RFC 4648, with padding.
std::string base64Of(std::string_view bytes);

/// The bytes of pairs of hexadecimal digits; stops at any other character.
std::string bytesOfHex(std::string_view digits);

}  // namespace fulbito
