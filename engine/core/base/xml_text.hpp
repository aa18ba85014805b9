#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fulbito {

/// Bytes of the UTF-8 character at byte `i`; 0 where there is none.
std::size_t characterSize(std::string_view utf8, std::size_t i);

/// For an attribute or text of XML or HTML: the five special characters escaped, and each byte or character
/// that XML forbids or that steers text (`steersText`), line ends too, replaced by a space.
std::string escapedXml(std::string_view utf8);

}  // namespace fulbito
