#include "replays/render/canvas/font.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

#include <SDL.h>

#include "engine/core/system/io_code.hpp"

namespace fulbito {
namespace {

constexpr double kSmallestText = 4.0, kLargestText = 400.0;  // [px]
constexpr std::size_t kMostMasks = 512;  // bound of the cache: clocks and measured values never stop changing
constexpr std::size_t kRoom = std::size_t{1} << 20;  // [bytes] more than SDL_ttf allocates at once

/// Guards SDL_ttf, which uses one FreeType library for the whole process without locking.
std::mutex& fontMutex() {
  static std::mutex mutex;
  return mutex;
}

/// SDL_ttf does not report a lack of memory. Throws std::bad_alloc if there is none.
void checkRoom() { const std::vector<char> room(kRoom); }

/// @return nullptr for an empty text
SDL_Surface* rendered(TTF_Font* font, const std::string& text, Colour colour) {
  SDL_Surface* const surface =
      TTF_RenderUTF8_Blended(font, text.c_str(), {colour.r, colour.g, colour.b, colour.a});
  if (surface == nullptr) checkRoom();
  return surface;
}

}  // namespace

Font::~Font() {
  const std::lock_guard lock(fontMutex());
  for (TTF_Font* font : fonts_) {
    if (font != nullptr) TTF_CloseFont(font);
  }
  if (library_) TTF_Quit();
}

Result<void> Font::open() {
  const std::lock_guard lock(fontMutex());
  if (TTF_Init() != 0) {
    checkRoom();
    return fail(ErrorCode::kIo, std::string("cannot start SDL_ttf: ") + TTF_GetError());
  }
  library_ = true;
  const char* chosen = std::getenv("FULBITO_FONT");
  const bool own = chosen != nullptr && *chosen != '\0';
  const std::string file = own ? chosen : FULBITO_DEFAULT_FONT;
  errno = 0;
  fonts_[0] = TTF_OpenFont(file.c_str(), sizes_[0]);
  if (const int reason = errno; fonts_[0] == nullptr && isShortage(reason)) {
    return fail(ioCode(reason), "cannot open the font " + file + ": " + std::strerror(reason));
  }
  if (fonts_[0] == nullptr) {
    checkRoom();
    return fail(ErrorCode::kIo, "cannot open the font " + file + " (" + TTF_GetError() +
                                    "); install fonts-dejavu-core or set FULBITO_FONT to a .ttf file");
  }
  // A font chosen by the user is made bold by thicker outlines.
  fonts_[1] = own ? nullptr : TTF_OpenFont(FULBITO_DEFAULT_BOLD_FONT, sizes_[1]);
  if (fonts_[1] == nullptr) {
    checkRoom();
    fonts_[1] = TTF_OpenFont(file.c_str(), sizes_[1]);
    if (fonts_[1] != nullptr) TTF_SetFontStyle(fonts_[1], TTF_STYLE_BOLD);
  }
  for (TTF_Font* font : fonts_) {
    if (font != nullptr) TTF_SetFontHinting(font, TTF_HINTING_LIGHT_SUBPIXEL);
  }
  return {};
}

TTF_Font* Font::at(double size, bool bold) {
  const int index = bold && fonts_[1] != nullptr ? 1 : 0;
  // A size that is not a number also becomes the largest one.
  const double most = size < kLargestText ? size : kLargestText;
  const int wanted = static_cast<int>(std::round(std::max(most, kSmallestText)));
  if (wanted != sizes_[index]) TTF_SetFontSize(fonts_[index], sizes_[index] = wanted);
  return fonts_[index];
}

int Font::width(const std::string& text, double size, bool bold) {
  const std::lock_guard lock(fontMutex());
  int width = 0;
  return TTF_SizeUTF8(at(size, bold), text.c_str(), &width, nullptr) == 0 ? width : 0;
}

SDL_Surface* Font::drawn(const std::string& text, double size, Colour colour, int& ascent) {
  const std::lock_guard lock(fontMutex());
  TTF_Font* font = at(size, false);
  ascent = TTF_FontAscent(font);
  return rendered(font, text, colour);
}

const TextMask& Font::mask(const std::string& text, double size, bool bold) {
  const Key key{text, static_cast<int>(std::round(size)), bold};
  if (const auto known = masks_.find(key); known != masks_.end()) return known->second;
  if (masks_.size() >= kMostMasks) masks_.clear();
  TextMask& mask = masks_[key];
  const std::lock_guard lock(fontMutex());
  TTF_Font* font = at(size, bold);
  mask.ascent = TTF_FontAscent(font);
  SDL_Surface* drawn = rendered(font, text, {255, 255, 255});
  if (drawn == nullptr) return mask;
  mask.width = drawn->w;
  mask.height = drawn->h;
  for (int y = 0; y < drawn->h; ++y) {
    const auto* row = static_cast<const std::uint8_t*>(drawn->pixels) + std::ptrdiff_t{y} * drawn->pitch;
    for (int x = 0; x < drawn->w; ++x) {
      mask.coverage.push_back(
          static_cast<std::uint8_t>(reinterpret_cast<const std::uint32_t*>(row)[x] >> 24));
    }
  }
  SDL_FreeSurface(drawn);
  return mask;
}

}  // namespace fulbito
