#include "engine/core/system/error_text.hpp"

#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace fulbito {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }

/// A character and its length in bytes; empty if the bytes are not UTF-8.
struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;
};

Character characterAt(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xf0 && lead < 0xf5 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 0;
  if (lead >= 0xf5 || size == 0 || text.size() - at < size) return {};
  std::uint32_t code = lead & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (!continues(text[at + i])) return {};
    code = code << 6 | (static_cast<unsigned char>(text[at + i]) & 0x3fu);
  }
  static constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};  // longer forms are not allowed
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < kLeast[size] || code > 0x10ffff || surrogate ? Character{} : Character{code, size};
}

bool isControl(std::uint32_t code) {
  if (code == '\n' || code == '\t') return false;
  const bool direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || direction;
}

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
    const Character c = characterAt(text, i);
    if (c.size == 0) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i++]));
      continue;
    }
    if (!isControl(c.code)) {
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
