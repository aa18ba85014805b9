#include "tournament/report/shown_text.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "engine/core/base/xml_text.hpp"

namespace fulbito {
namespace {

/// A range of code points; both ends are included.
struct Range {
  std::uint32_t first, last;
};

// Wide characters after M. Kuhn, wcwidth.c (2007), and emoji.
constexpr Range kWide[] = {{0x1100, 0x115F},   {0x2329, 0x232A},  {0x2E80, 0x303E},   {0x3040, 0xA4CF},
                           {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},  {0xFE10, 0xFE19},   {0xFE30, 0xFE6F},
                           {0xFF00, 0xFF60},   {0xFFE0, 0xFFE6},  {0x1F300, 0x1F64F}, {0x1F900, 0x1F9FF},
                           {0x20000, 0x2FFFD}, {0x30000, 0x3FFFD}};
// Controls, line and paragraph separators, and characters that XML forbids.
constexpr Range kBlank[] = {{0x00, 0x1F}, {0x7F, 0x9F}, {0x2028, 0x2029}, {0xFFFE, 0xFFFF}};
// Direction marks (Unicode's UAX 9), zero-width characters, tags.
constexpr Range kInvisible[] = {{0xAD, 0xAD},     {0x061C, 0x061C}, {0x180E, 0x180E}, {0x200B, 0x200F},
                                {0x202A, 0x202E}, {0x2060, 0x206F}, {0xFEFF, 0xFEFF}, {0xE0000, 0xE007F}};

template <std::size_t N>
bool isIn(const Range (&ranges)[N], std::uint32_t character) {
  return std::any_of(std::begin(ranges), std::end(ranges),
                     [&](const Range& r) { return character >= r.first && character <= r.last; });
}

/// The code point of one valid UTF-8 character.
std::uint32_t codePoint(std::string_view utf8) {
  const auto first = static_cast<unsigned char>(utf8[0]);
  if (utf8.size() == 1) return first;
  std::uint32_t code = first & (0xFFu >> (utf8.size() + 1));
  for (const char c : utf8.substr(1)) code = code << 6u | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

int columnsOfCharacter(std::uint32_t character) { return isIn(kWide, character) ? 2 : 1; }

/// Removes the first character from `text` and returns it; invalid bytes and controls become spaces.
std::string_view nextCharacter(std::string_view& text) {
  const std::size_t size = characterSize(text, 0);
  const std::string_view character = text.substr(0, std::max<std::size_t>(size, 1));
  text.remove_prefix(character.size());
  return size == 0 || isIn(kBlank, codePoint(character)) ? " " : character;
}

}  // namespace

int columnsOf(std::string_view utf8) {
  int columns = 0;
  while (!utf8.empty()) columns += columnsOfCharacter(codePoint(nextCharacter(utf8)));
  return columns;
}

std::string shownText(std::string_view text, int columns) {
  std::string out;
  int used = 0;
  std::size_t fits = 0;  // bytes of `out` after which "…" still fits
  while (!text.empty()) {
    const std::string_view character = nextCharacter(text);
    const std::uint32_t code = codePoint(character);
    if (isIn(kInvisible, code)) continue;
    used += columnsOfCharacter(code);
    if (used > columns) return out.substr(0, fits) + "…";
    out += character;
    if (used < columns) fits = out.size();
  }
  return out;
}

std::string padded(const std::string& text, int columns, bool before) {
  const std::string room(static_cast<std::size_t>(std::max(0, columns - columnsOf(text))), ' ');
  return before ? room + text : text + room;
}

}  // namespace fulbito
