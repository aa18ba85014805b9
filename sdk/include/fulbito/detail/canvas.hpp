#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "fulbito/detail/values.hpp"
#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// The colours of a match's picture.
enum class PictureTheme : std::uint8_t { kDark, kLight };

/// Red, green, blue and opacity, 0 ... 255.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;  ///< 255 is opaque
};

/// The end or the centre of a text that lies at its position.
enum class TextAlign { kLeft, kCentre, kRight };

/// The aim of PNG compression: speed or size.
enum class PngEffort { kFast, kSmall };

/// The style of a label.
struct TextStyle {
  double size = 14.0;                  ///< [px] as `Canvas::text`
  Colour colour;                       ///< colour of its letters
  TextAlign align = TextAlign::kLeft;  ///< the part of the text that lies at its position
  bool bold = false;                   ///< by the bold font, or a bold outline
};

/// A picture in memory: an SDL2 surface that needs no screen. Coordinates are pixels, y down, (0, 0) the
/// upper left corner of the picture; all edges are anti-aliased. Calls ignore parts outside the picture, and
/// points that are not finite or farther than 1e6 pixels away. The same calls give the same pixels with the
/// same SDL, SDL_ttf and FreeType. Several threads may use different canvases at once.
class Canvas {
 public:
  /// Creates a canvas. The font is DejaVu Sans as found at configuration, or the file in the environment
  /// variable FULBITO_FONT. Errors: kIo if SDL or the font is unavailable; kUsage if a side is not 1 ...
  /// 16384 or the picture has more than 64 million pixels.
  static Result<Canvas> create(int width, int height, Colour background);
  /// A moved-from canvas can only be destroyed or assigned to.
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  /// Width [px] of the picture.
  int width() const;
  /// Height [px] of the picture.
  int height() const;
  /// Fills a rectangle; `corner` is its upper left corner.
  void fillRectangle(Vec2 corner, double width, double height, Colour colour);
  /// Fills a polygon that must not cross itself; the last point joins the first.
  void fillPolygon(std::span<const Vec2> points, Colour colour);
  /// As fillPolygon for a convex polygon in either sense; much faster.
  void fillConvex(std::span<const Vec2> points, Colour colour);
  /// Fills a disc.
  void fillCircle(Vec2 centre, double radius, Colour colour);
  /// Draws a ring around `radius`.
  void circle(Vec2 centre, double radius, double thickness, Colour colour);
  /// Draws a line with round ends, as `polyline`.
  void line(Vec2 a, Vec2 b, double thickness, Colour colour);
  /// Draws an open polyline. A translucent colour does not add up where the line crosses itself.
  void polyline(std::span<const Vec2> points, double thickness, Colour colour);
  /// Draws a trail: a polyline from transparent at its first point to `colour` at its last, and from the
  /// thickness `first` to `last`.
  void fadingLine(std::span<const Vec2> points, double first, double last, Colour colour);
  /// Draws one line of text. `size` [px] is the height from the top of the tallest letter to the bottom of
  /// the lowest, 4 ... 400, rounded to whole pixels. Line breaks become blanks.
  void text(Vec2 baseline, const std::string& utf8, double size, Colour colour,
            TextAlign align = TextAlign::kLeft);
  /// Width [px] of `text` with these arguments.
  double textWidth(const std::string& utf8, double size) const;

  /// As `text`, at fractions of a pixel, so that it can move with a body. Repeated words come from a cache.
  void label(Vec2 baseline, const std::string& utf8, const TextStyle& style);
  /// Width [px] of `label` with these arguments.
  double labelWidth(const std::string& utf8, const TextStyle& style) const;

  /// Blends one pixel; does nothing outside the picture.
  void fillPixel(int x, int y, Colour colour);
  /// Copies a whole picture without blending; its upper left corner comes to (x, y).
  void place(const Canvas& picture, int x, int y);
  /// Copies the pixels of a picture of the same size; does nothing for another size.
  void copyFrom(const Canvas& other);
  /// The pixels of a row, 0xAARRGGBB each; `y` must be in the picture.
  std::span<const std::uint32_t> row(int y) const;

  /// The bytes of an 8-bit PNG file; empty if memory runs out.
  std::string png(PngEffort effort) const;
  /// Writes an 8-bit PNG through a temporary file next to it. Errors: kIo naming the file.
  Result<void> writePng(const std::string& file) const;
  /// Colour of a pixel, for tests; transparent black outside the picture.
  Colour pixel(int x, int y) const;

 private:
  struct Impl;
  explicit Canvas(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
