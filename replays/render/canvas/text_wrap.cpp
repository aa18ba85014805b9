#include "replays/render/canvas/text_wrap.hpp"

#include <string_view>

namespace fulbito {
namespace {

constexpr std::size_t kLongest = 4096;  // more than any picture can show; the rest would only take time

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Splits a text at all places where a line may be broken.
std::vector<std::string> piecesOf(const std::string& text) {
  std::vector<std::string> pieces(1);
  for (char c : text.substr(0, kLongest)) {
    pieces.back() += c;
    if (std::string_view(" ,:-").find(c) != std::string_view::npos) pieces.emplace_back();
  }
  return pieces;
}

std::string trimmed(std::string line) {
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

}  // namespace

std::vector<std::string> wrapped(const Canvas& canvas, const std::string& utf8, double size, double width) {
  std::vector<std::string> lines(1);
  const auto fits = [&](const std::string& text) { return canvas.textWidth(trimmed(text), size) <= width; };
  for (const std::string& piece : piecesOf(utf8)) {
    if (fits(lines.back() + piece)) {
      lines.back() += piece;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    for (std::size_t i = 0; i < piece.size();) {
      std::size_t end = i + 1;
      while (end < piece.size() && continuesCharacter(piece[end])) ++end;
      const std::string character = piece.substr(i, end - i);
      if (!lines.back().empty() && !fits(lines.back() + character)) lines.emplace_back();
      lines.back() += character;
      i = end;
    }
  }
  if (lines.size() > 1 && trimmed(lines.back()).empty()) lines.pop_back();
  for (std::string& line : lines) line = trimmed(std::move(line));
  return lines;
}

}  // namespace fulbito
