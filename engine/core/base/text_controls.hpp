#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Functions for untrusted text, such as names of teams and files, and texts in recordings. Such text is
/// stored unchanged. Whatever shows it to people or passes it to other programs applies one of these
/// functions, `terminalText` or `escapedXml`.
namespace fulbito {

/// A character and the length of its UTF-8 encoding [bytes]; length 0 if the bytes are not UTF-8.
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t size = 0;
};
/// The character at byte `at`.
Utf8Character characterAt(std::string_view utf8, std::size_t at);

/// Whether a character steers how a text is shown, instead of being shown: a control (C0, DEL, C1), a line or
/// paragraph separator, or a mark of writing direction that reaches beyond its word (Unicode's UAX 9).
bool steersText(std::uint32_t code);

/// The text as part of one line: characters that steer it (`steersText`) and invalid UTF-8 become spaces.
std::string oneLine(std::string_view text);

/// The same JSON with all characters that steer text (`steersText`) escaped. Line ends stay.
std::string escapedJson(std::string json);

/// A field of a CSV file by RFC 4180, in quotes, as one line. A field that a spreadsheet would take for a
/// formula has an apostrophe in front, as OWASP advises ("CSV Injection").
std::string csvField(std::string_view text);

}  // namespace fulbito
