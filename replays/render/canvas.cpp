#include "replays/render/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>

#include <SDL.h>
#include <SDL_ttf.h>

#include "replays/render/coverage.hpp"
#include "replays/render/png_file.hpp"

namespace fulbito {
namespace {

constexpr int kLongestSide = 16384;                          // [px]
constexpr std::int64_t kMostPixels = 64'000'000;             // 256 MB
constexpr double kSmallestText = 4.0, kLargestText = 400.0;  // [px]

/// SDL_ttf keeps one FreeType library for the whole process, which is not safe in several threads.
std::mutex& fontMutex() {
  static std::mutex mutex;
  return mutex;
}

/// The font of one canvas, opened once.
class Font {
 public:
  Font() = default;
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  ~Font() {
    const std::lock_guard lock(fontMutex());
    if (font_ != nullptr) TTF_CloseFont(font_);
    if (library_) TTF_Quit();
  }

  Result<void> open() {
    const std::lock_guard lock(fontMutex());
    if (TTF_Init() != 0) return fail(ErrorCode::kIo, std::string("cannot start SDL_ttf: ") + TTF_GetError());
    library_ = true;
    const char* chosen = std::getenv("FULBITO_FONT");
    const std::string file = chosen != nullptr && *chosen != '\0' ? chosen : FULBITO_DEFAULT_FONT;
    font_ = TTF_OpenFont(file.c_str(), size_);
    if (font_ == nullptr) {
      return fail(ErrorCode::kIo, "cannot open the font " + file + " (" + TTF_GetError() +
                                      "); install fonts-dejavu-core or set FULBITO_FONT to a .ttf file");
    }
    TTF_SetFontHinting(font_, TTF_HINTING_LIGHT_SUBPIXEL);
    return {};
  }

  int width(const std::string& text, double size) {
    const std::lock_guard lock(fontMutex());
    setSize(size);
    int width = 0;
    return TTF_SizeUTF8(font_, text.c_str(), &width, nullptr) == 0 ? width : 0;
  }

  /// A picture of `text` and how far its baseline lies below its top; null when it is empty.
  SDL_Surface* drawn(const std::string& text, double size, Colour colour, int& ascent) {
    const std::lock_guard lock(fontMutex());
    setSize(size);
    ascent = TTF_FontAscent(font_);
    return TTF_RenderUTF8_Blended(font_, text.c_str(), {colour.r, colour.g, colour.b, colour.a});
  }

 private:
  void setSize(double size) {
    const int wanted = static_cast<int>(std::round(std::clamp(size, kSmallestText, kLargestText)));
    if (wanted != size_) TTF_SetFontSize(font_, size_ = wanted);
  }

  TTF_Font* font_ = nullptr;
  bool library_ = false;
  int size_ = 16;
};

/// Line breaks and tabs have no glyph.
std::string printable(std::string text) {
  std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
  return text;
}

std::uint8_t mixed(std::uint32_t below, std::uint32_t above, std::uint32_t weight, std::uint32_t whole) {
  return static_cast<std::uint8_t>((below * (whole - weight) + above * weight + whole / 2) / whole);
}

/// `above` over `below`, with `coverage` 0...255 as a further factor of its opacity.
Colour over(Colour below, Colour above, std::uint32_t coverage) {
  const std::uint32_t alpha = (above.a * coverage + 127) / 255;
  if (alpha == 0) return below;
  const std::uint32_t whole = alpha + (below.a * (255 - alpha) + 127) / 255;
  return {mixed(below.r, above.r, alpha, whole), mixed(below.g, above.g, alpha, whole),
          mixed(below.b, above.b, alpha, whole), static_cast<std::uint8_t>(whole)};
}

std::uint32_t packed(Colour c) {
  return static_cast<std::uint32_t>(c.a) << 24 | static_cast<std::uint32_t>(c.r) << 16 |
         static_cast<std::uint32_t>(c.g) << 8 | c.b;
}

Colour unpacked(std::uint32_t argb) {
  return {static_cast<std::uint8_t>(argb >> 16), static_cast<std::uint8_t>(argb >> 8),
          static_cast<std::uint8_t>(argb), static_cast<std::uint8_t>(argb >> 24)};
}

}  // namespace

struct Canvas::Impl {
  Impl(int width, int height)
      : surface(SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888)),
        mask(width, height) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { SDL_FreeSurface(surface); }

  std::uint32_t& at(int x, int y) const {
    auto* row = static_cast<std::uint8_t*>(surface->pixels) + static_cast<std::ptrdiff_t>(y) * surface->pitch;
    return reinterpret_cast<std::uint32_t*>(row)[x];
  }
  void paint(Colour colour) {
    mask.drain([&](int x, int y, std::uint8_t coverage) {
      std::uint32_t& pixel = at(x, y);
      pixel = packed(over(unpacked(pixel), colour, coverage));
    });
  }

  SDL_Surface* surface;
  CoverageMask mask;
  mutable Font font;
};

Canvas::Canvas(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

Result<Canvas> Canvas::create(int width, int height, Colour background) {
  if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide ||
      static_cast<std::int64_t>(width) * height > kMostPixels) {
    return fail(ErrorCode::kUsage, "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                       " pixels is not possible: each side must be 1 to " +
                                       std::to_string(kLongestSide) + " and the whole at most " +
                                       std::to_string(kMostPixels / 1'000'000) + " million pixels");
  }
  auto impl = std::make_unique<Impl>(width, height);
  if (impl->surface == nullptr) {
    return fail(ErrorCode::kIo, std::string("cannot make a picture: ") + SDL_GetError());
  }
  if (auto opened = impl->font.open(); !opened) return tl::unexpected(opened.error());
  SDL_FillRect(impl->surface, nullptr, packed(background));
  return Canvas(std::move(impl));
}

int Canvas::width() const { return impl_->surface->w; }
int Canvas::height() const { return impl_->surface->h; }

void Canvas::fillRectangle(Vec2 corner, double width, double height, Colour colour) {
  impl_->mask.addRectangle(corner, width, height);
  impl_->paint(colour);
}

void Canvas::fillPolygon(std::span<const Vec2> points, Colour colour) {
  impl_->mask.addPolygon(points);
  impl_->paint(colour);
}

void Canvas::fillCircle(Vec2 centre, double radius, Colour colour) {
  impl_->mask.addDisc(centre, radius);
  impl_->paint(colour);
}

void Canvas::circle(Vec2 centre, double radius, double thickness, Colour colour) {
  impl_->mask.addRing(centre, radius, thickness);
  impl_->paint(colour);
}

void Canvas::line(Vec2 a, Vec2 b, double thickness, Colour colour) {
  impl_->mask.addStroke(a, b, thickness);
  impl_->paint(colour);
}

void Canvas::polyline(std::span<const Vec2> points, double thickness, Colour colour) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    impl_->mask.addStroke(points[i - 1], points[i], thickness);
  }
  impl_->paint(colour);
}

void Canvas::text(Vec2 baseline, const std::string& utf8, double size, Colour colour, TextAlign align) {
  if (utf8.empty() || !(std::abs(baseline.x) < 1e6 && std::abs(baseline.y) < 1e6)) return;
  int ascent = 0;
  SDL_Surface* drawn = impl_->font.drawn(printable(utf8), size, colour, ascent);
  if (drawn == nullptr) return;
  const double part = align == TextAlign::kLeft ? 0.0 : align == TextAlign::kCentre ? 0.5 : 1.0;
  SDL_Rect place{static_cast<int>(std::round(baseline.x - part * drawn->w)),
                 static_cast<int>(std::round(baseline.y)) - ascent, drawn->w, drawn->h};
  SDL_BlitSurface(drawn, nullptr, impl_->surface, &place);
  SDL_FreeSurface(drawn);
}

double Canvas::textWidth(const std::string& utf8, double size) const {
  return impl_->font.width(printable(utf8), size);
}

Result<void> Canvas::writePng(const std::string& file) const {
  return writePngFile(file, width(), height(), impl_->surface->pixels, impl_->surface->pitch);
}

Colour Canvas::pixel(int x, int y) const {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return {0, 0, 0, 0};
  return unpacked(impl_->at(x, y));
}

}  // namespace fulbito
