#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Texts from outside: names of teams, of files, of what a recording says. They are kept as they are; what
/// goes out to people or other programs passes one of these functions, `terminalText` or `escapedXml`.
namespace fulbito {

/// A character and its length in bytes; of length 0 where there is no UTF-8.
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t size = 0;
};
/// The character at byte `at`.
Utf8Character characterAt(std::string_view utf8, std::size_t at);

/// Whether a character steers how a text is shown, instead of being shown: a control (C0, DEL, C1), a line or
/// paragraph separator, or a mark of writing direction that reaches beyond its word (Unicode's UAX 9).
bool steersText(std::uint32_t code);

/// The text as a part of one line: what steers it and what is no UTF-8 becomes a space.
std::string oneLine(std::string_view text);

/// JSON text with the same content, in which what steers text is escaped. Its own line ends stay.
std::string escapedJson(std::string json);

/// A field of a CSV file by RFC 4180, in quotes, as one line. A field that a spreadsheet would take for a
/// formula has an apostrophe in front, as OWASP advises ("CSV Injection").
std::string csvField(std::string_view text);

}  // namespace fulbito
