#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <SDL_ttf.h>

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A line of text as coverage (0...255) of its pixels.
struct TextMask {
  int width = 0;
  int height = 0;
  int ascent = 0;  ///< [px] from the top of the mask to the baseline
  std::vector<std::uint8_t> coverage;
};

/// The fonts of one canvas. They are opened once.
class Font {
 public:
  Font() = default;
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  ~Font();

  /// Opens the fonts. Errors: kIo naming the file.
  Result<void> open();
  int width(const std::string& text, double size, bool bold = false);
  /// Renders `text` in a colour; `ascent` becomes the distance from top to baseline [px]. Null for an empty
  /// text.
  SDL_Surface* drawn(const std::string& text, double size, Colour colour, int& ascent);
  /// Renders the text as a mask and caches it. The reference is valid until the next call.
  const TextMask& mask(const std::string& text, double size, bool bold);

 private:
  using Key = std::tuple<std::string, int, bool>;

  /// The font with this weight, set to this size.
  TTF_Font* at(double size, bool bold);

  TTF_Font* fonts_[2] = {nullptr, nullptr};  ///< index 0: regular, 1: bold
  int sizes_[2] = {16, 16};
  bool library_ = false;
  std::map<Key, TextMask> masks_;
};

}  // namespace fulbito
