// JSON as text: numbers and strings at the end of a buffer. For the line protocol of teams.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include "fulbito/detail/lines/utf8.hpp"

namespace fulbito::json {

/// Appends a whole number.
inline void append(std::string& out, std::integral auto value)
  requires(!std::same_as<decltype(value), bool>)
{
  char digits[24];  // enough for 64 bits and a sign
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, static_cast<std::size_t>(end.ptr - digits));
}

/// Appends "true" or "false".
inline void append(std::string& out, bool value) { out += value ? "true" : "false"; }

/// Appends "null".
inline void append(std::string& out, std::nullptr_t) { out += "null"; }

/// Appends the shortest text that reads back to the same bits. It always has a point or an exponent, so that
/// readers that tell whole numbers from others keep the type, and the sign of -0. JSON has no NaN and no
/// infinity: they become null.
inline void append(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  char digits[32];  // the shortest text of a double has at most 24 characters
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  const std::string_view text(digits, static_cast<std::size_t>(end.ptr - digits));
  out += text;
  // Only whole numbers need the search for a point.
  if (std::trunc(value) == value && text.find_first_of(".e") == std::string_view::npos) out += ".0";
}

/// Appends a string with quotes and escapes. Bytes that are not UTF-8 become U+FFFD.
inline void append(std::string& out, std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  out += '"';
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte >= 0x80) {
      const std::size_t length = utf8Length(text.substr(i));
      out += length > 0 ? text.substr(i, length) : std::string_view("\xEF\xBF\xBD");
      i += length > 0 ? length : 1;
      continue;
    }
    if (byte < 0x20 || byte == 0x7f) {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      if (byte == '"' || byte == '\\') out += '\\';
      out += text[i];
    }
    ++i;
  }
  out += '"';
}

/// The overload for literals, which would otherwise convert to bool.
inline void append(std::string& out, const char* text) { append(out, std::string_view(text)); }

}  // namespace fulbito::json
