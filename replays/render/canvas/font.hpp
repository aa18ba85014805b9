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

/// A line of text as coverage 0...255 of its pixels.
struct TextMask {
  int width = 0;
  int height = 0;
  int ascent = 0;  ///< [px] from its top to its baseline
  std::vector<std::uint8_t> coverage;
};

/// The fonts of one canvas, opened once.
class Font {
 public:
  Font() = default;
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  ~Font();

  /// Errors: kIo naming the file.
  Result<void> open();
  int width(const std::string& text, double size, bool bold = false);
  /// A picture of `text` and how far its baseline lies below its top; null when it is empty.
  SDL_Surface* drawn(const std::string& text, double size, Colour colour, int& ascent);
  /// The same as a mask that is kept for the next time; valid up to the next call.
  const TextMask& mask(const std::string& text, double size, bool bold);

 private:
  using Key = std::tuple<std::string, int, bool>;

  /// The font of that weight at that size.
  TTF_Font* at(double size, bool bold);

  TTF_Font* fonts_[2] = {nullptr, nullptr};  ///< regular, bold
  int sizes_[2] = {16, 16};
  bool library_ = false;
  std::map<Key, TextMask> masks_;
};

}  // namespace fulbito
