#pragma once

#include <string>
#include <string_view>

namespace fulbito {

/// Base64 (RFC 4648) with padding.
std::string base64Of(std::string_view bytes);

/// The bytes given as pairs of hexadecimal digits. Stops at the first other character.
std::string bytesOfHex(std::string_view digits);

}  // namespace fulbito
