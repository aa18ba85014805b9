#include "engine/core/system/error_text.hpp"

#include <utility>

#include <fmt/format.h>

#include "engine/core/base/text_controls.hpp"

namespace fulbito {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }

}  // namespace

tl::unexpected<Error> inFile(const std::string& file, Error error) {
  if (!error.message.starts_with(file + ":") && error.code != ErrorCode::kInterrupted) {
    error.message = file + ": " + error.message;
  }
  return tl::unexpected<Error>(std::move(error));
}

std::string terminalText(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = characterAt(text, i);
    if (c.size == 0) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i++]));
      continue;
    }
    if (c.code == '\n' || c.code == '\t' || !steersText(c.code)) {
      out += text.substr(i, c.size);
    } else {
      out += c.code < 0x80 ? fmt::format("\\x{:02x}", c.code) : fmt::format("\\u{:04x}", c.code);
    }
    i += c.size;
  }
  return out;
}

std::string_view firstBytes(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && continues(text[most])) --most;
  return text.substr(0, most);
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  const std::string_view head = firstBytes(text, most * 2 / 3);
  std::size_t tail = text.size() - most / 4;
  while (tail < text.size() && continues(text[tail])) ++tail;
  return fmt::format("{} [... {} bytes omitted ...] {}", head, tail - head.size(), text.substr(tail));
}

}  // namespace fulbito
