#include "engine/core/base/xml_text.hpp"

#include <algorithm>

#include "engine/core/base/text_controls.hpp"

namespace fulbito {
namespace {

const char* entityOf(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return nullptr;
  }
}

}  // namespace

std::size_t characterSize(std::string_view utf8, std::size_t i) {
  const auto byte = [&](std::size_t k) -> unsigned {
    return k < utf8.size() ? static_cast<unsigned char>(utf8[k]) : 0u;
  };
  const unsigned first = byte(i);
  if (first < 0x80u) return 1;
  const std::size_t size = first >= 0xF0u && first < 0xF5u ? 4 : first >= 0xE0u ? 3 : first >= 0xC2u ? 2 : 0;
  if (size == 0 || first >= 0xF5u) return 0;
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(i + k) & 0xC0u) != 0x80u) return 0;
  }
  const unsigned second = byte(i + 1);
  const bool overlong = (first == 0xE0u && second < 0xA0u) || (first == 0xF0u && second < 0x90u);
  const bool beyond = (first == 0xEDu && second >= 0xA0u) || (first == 0xF4u && second >= 0x90u);
  return overlong || beyond ? 0 : size;
}

std::string escapedXml(std::string_view utf8) {
  std::string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const std::size_t size = characterSize(utf8, i);
    const std::string_view character = utf8.substr(i, std::max<std::size_t>(size, 1));
    i += character.size();
    const bool bad = size == 0 || steersText(characterAt(character, 0).code) || character == "\xEF\xBF\xBE" ||
                     character == "\xEF\xBF\xBF";
    if (bad) {
      out += ' ';
    } else if (const char* entity = entityOf(character[0]); entity != nullptr) {
      out += entity;
    } else {
      out += character;
    }
  }
  return out;
}

}  // namespace fulbito
