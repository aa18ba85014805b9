#include "fulbito/detail/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include <SDL.h>

#include "replays/render/canvas/coverage.hpp"
#include "replays/render/canvas/font.hpp"
#include "replays/render/canvas/png_file.hpp"

namespace fulbito {
namespace {

constexpr int kLongestSide = 16384;               // [px]
constexpr std::int64_t kMostPixels = 64'000'000;  // 256 MB

/// Replaces line breaks and tabs by spaces, because they have no glyph.
std::string printable(std::string text) {
  std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
  return text;
}

constexpr std::uint8_t mixed(std::uint32_t below, std::uint32_t above, std::uint32_t weight,
                             std::uint32_t whole) {
  return static_cast<std::uint8_t>((below * (whole - weight) + above * weight + whole / 2) / whole);
}

/// `above` blended over `below`. `coverage` (0...255) is a further factor of the opacity.
Colour over(Colour below, Colour above, std::uint32_t coverage) {
  const std::uint32_t alpha = (above.a * coverage + 127) / 255;
  if (alpha == 0) return below;
  if (alpha == 255) return above;
  const std::uint32_t whole = below.a == 255 ? 255 : alpha + (below.a * (255 - alpha) + 127) / 255;
  if (whole == 255) {  // a division by a constant compiles to a multiplication
    return {mixed(below.r, above.r, alpha, 255), mixed(below.g, above.g, alpha, 255),
            mixed(below.b, above.b, alpha, 255), 255};
  }
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

void* checked(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// Makes SDL throw std::bad_alloc. By default it allocates an error message when memory runs out, and
/// crashes.
void useCheckedMemory() {
  [[maybe_unused]] static const int once = SDL_SetMemoryFunctions(
      [](std::size_t size) { return checked(std::malloc(size)); },
      [](std::size_t count, std::size_t size) { return checked(std::calloc(count, size)); },
      [](void* memory, std::size_t size) { return checked(std::realloc(memory, size)); }, std::free);
}

SDL_Surface* newSurface(int width, int height) {
  useCheckedMemory();
  return SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888);
}

}  // namespace

struct Canvas::Impl {
  Impl(int width, int height) : surface(newSurface(width, height)), mask(width, height) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { SDL_FreeSurface(surface); }

  std::uint32_t& at(int x, int y) const {
    auto* row = static_cast<std::uint8_t*>(surface->pixels) + static_cast<std::ptrdiff_t>(y) * surface->pitch;
    return reinterpret_cast<std::uint32_t*>(row)[x];
  }
  void blend(int x, int y, Colour colour, std::uint32_t coverage) const {
    std::uint32_t& pixel = at(x, y);
    pixel = packed(over(unpacked(pixel), colour, coverage));
  }
  void paint(Colour colour) {
    mask.drain([&](int x, int y, std::uint8_t coverage) { blend(x, y, colour, coverage); });
  }

  SDL_Surface* surface;
  CoverageMask mask;
  mutable Font font;
  PngEncoder encoder;
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
    return fail(ErrorCode::kMachine, std::string("cannot make a picture: ") + SDL_GetError());
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

void Canvas::fillConvex(std::span<const Vec2> points, Colour colour) {
  impl_->mask.addConvex(points);
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

void Canvas::fadingLine(std::span<const Vec2> points, double first, double last, Colour colour) {
  const auto end = [&](std::size_t i) {
    const double share = static_cast<double>(i) / (static_cast<double>(points.size()) - 1.0);
    return CoverageMask::TaperEnd{points[i], first + (last - first) * share, share};
  };
  for (std::size_t i = 1; i < points.size(); ++i) impl_->mask.addTaper(end(i - 1), end(i));
  impl_->paint(colour);
}

void Canvas::label(Vec2 place, const std::string& utf8, const TextStyle& style) {
  if (utf8.empty() || !(std::abs(place.x) < 1e6 && std::abs(place.y) < 1e6)) return;
  const TextMask& mask = impl_->font.mask(printable(utf8), style.size, style.bold);
  const double part = style.align == TextAlign::kLeft ? 0.0 : style.align == TextAlign::kCentre ? 0.5 : 1.0;
  const double left = place.x - part * mask.width, top = place.y - mask.ascent;
  const double x0 = std::floor(left), y0 = std::floor(top);
  // Bilinear weights in 1/256. At whole pixels, the letters stay unchanged.
  const auto fx = static_cast<std::uint32_t>((left - x0) * 256.0);
  const auto fy = static_cast<std::uint32_t>((top - y0) * 256.0);
  const auto covered = [&mask](int x, int y) -> std::uint32_t {
    const bool inside = x >= 0 && y >= 0 && x < mask.width && y < mask.height;
    return inside ? mask.coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                                  static_cast<std::size_t>(x)]
                  : 0;
  };
  const int column = static_cast<int>(x0), row = static_cast<int>(y0);
  for (int y = std::max(0, -row); y <= mask.height && row + y < height(); ++y) {
    for (int x = std::max(0, -column); x <= mask.width && column + x < width(); ++x) {
      const std::uint32_t upper = covered(x - 1, y - 1) * fx + covered(x, y - 1) * (256 - fx);
      const std::uint32_t lower = covered(x - 1, y) * fx + covered(x, y) * (256 - fx);
      const std::uint32_t coverage = (upper * fy + lower * (256 - fy) + 32768) >> 16;
      if (coverage != 0) impl_->blend(column + x, row + y, style.colour, coverage);
    }
  }
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

double Canvas::labelWidth(const std::string& utf8, const TextStyle& style) const {
  return impl_->font.width(printable(utf8), style.size, style.bold);
}

void Canvas::fillPixel(int x, int y, Colour colour) {
  if (x >= 0 && y >= 0 && x < width() && y < height()) impl_->blend(x, y, colour, 255);
}

void Canvas::place(const Canvas& picture, int x, int y) {
  const int left = std::max(0, -x), right = std::min(picture.width(), width() - x);
  if (left >= right) return;
  for (int row = std::max(0, -y); row < std::min(picture.height(), height() - y); ++row) {
    std::copy_n(&picture.impl_->at(left, row), right - left, &impl_->at(x + left, y + row));
  }
}

void Canvas::copyFrom(const Canvas& other) {
  const SDL_Surface* from = other.impl_->surface;
  if (from->w != width() || from->h != height()) return;
  std::memcpy(impl_->surface->pixels, from->pixels, static_cast<std::size_t>(from->pitch) * from->h);
}

std::span<const std::uint32_t> Canvas::row(int y) const {
  return {&impl_->at(0, y), static_cast<std::size_t>(width())};
}

std::string Canvas::png(PngEffort effort) const {
  return impl_->encoder.encode(width(), height(), impl_->surface->pixels, impl_->surface->pitch, effort);
}

Result<void> Canvas::writePng(const std::string& file) const {
  return writePngFile(file, png(PngEffort::kSmall));
}

Colour Canvas::pixel(int x, int y) const {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return {0, 0, 0, 0};
  return unpacked(impl_->at(x, y));
}

}  // namespace fulbito
