#include "engine/core/base/text_controls.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"

namespace fulbito {

Utf8Character characterAt(std::string_view utf8, std::size_t at) {
  const std::size_t size = characterSize(utf8, at);
  if (size == 0) return {};
  const auto lead = static_cast<unsigned char>(utf8[at]);
  std::uint32_t code = size == 1 ? lead : lead & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    code = code << 6 | (static_cast<unsigned char>(utf8[at + i]) & 0x3fu);
  }
  return {code, size};
}

bool steersText(std::uint32_t code) {
  const bool direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029 || direction;
}

std::string oneLine(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = characterAt(text, i);
    if (c.size == 0 || steersText(c.code)) {
      out += ' ';
    } else {
      out += text.substr(i, c.size);
    }
    i += std::max<std::size_t>(c.size, 1);
  }
  return out;
}

std::string escapedJson(std::string json) {
  // Most texts are printable ASCII: they need no escapes.
  const auto plain = [](char c) { return (c >= 0x20 && c < 0x7f) || c == '\n'; };
  if (std::all_of(json.begin(), json.end(), plain)) return json;
  std::string out;
  out.reserve(json.size() + 64);
  for (std::size_t i = 0; i < json.size();) {
    const Utf8Character c = characterAt(json, i);
    const std::size_t size = std::max<std::size_t>(c.size, 1);
    if (c.size > 0 && c.code >= 0x7f && steersText(c.code)) {
      out += fmt::format("\\u{:04x}", c.code);
    } else {
      out.append(json, i, size);
    }
    i += size;
  }
  return out;
}

std::string csvField(std::string_view text) {
  constexpr std::string_view kFormula = "=+-@";
  std::string out = "\"";
  if (!text.empty() && (kFormula.find(text.front()) != std::string_view::npos || text.front() == '\t' ||
                        text.front() == '\r')) {
    out += '\'';
  }
  for (const char c : oneLine(text)) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

}  // namespace fulbito
