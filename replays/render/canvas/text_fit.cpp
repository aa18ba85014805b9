#include "replays/render/canvas/text_fit.hpp"

namespace fulbito {
namespace {

constexpr const char* kEllipsis = "\u2026";
// Longer than fits in any picture, and short enough to be measured quickly.
constexpr std::size_t kLongest = 4096;

/// The position at or before `end` that is a boundary between characters.
std::size_t characterEnd(const std::string& utf8, std::size_t end) {
  while (end > 0 && end < utf8.size() && (static_cast<unsigned char>(utf8[end]) & 0xC0U) == 0x80U) --end;
  return end;
}

}  // namespace

std::string fitted(const Canvas& canvas, const std::string& utf8, double size, double width) {
  if (utf8.size() <= kLongest && canvas.textWidth(utf8, size) <= width) return utf8;
  std::size_t fits = 0, too_long = std::min(utf8.size(), kLongest) + 1;
  while (too_long - fits > 1) {
    const std::size_t middle = (fits + too_long) / 2;
    const std::string cut = utf8.substr(0, characterEnd(utf8, middle)) + kEllipsis;
    (canvas.textWidth(cut, size) <= width ? fits : too_long) = middle;
  }
  const std::size_t end = characterEnd(utf8, fits);
  return end > 0 ? utf8.substr(0, end) + kEllipsis : std::string();
}

}  // namespace fulbito
