#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "fulbito/detail/vec2.hpp"
#include "fulbito/values.hpp"

namespace fulbito {

/// Which colours a match's picture has.
enum class PictureTheme : std::uint8_t { kDark, kLight };

/// Red, green, blue and opacity, 0 ... 255.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;  ///< 255 is opaque
};

/// Which point of a text stands at its place.
enum class TextAlign { kLeft, kCentre, kRight };

/// What a PNG should be: made quickly, or small.
enum class PngEffort { kFast, kSmall };

/// How a label is written.
struct TextStyle {
  double size = 14.0;                  ///< [px] as `Canvas::text`
  Colour colour;                       ///< of its letters
  TextAlign align = TextAlign::kLeft;  ///< which point of it stands at its place
  bool bold = false;                   ///< by the bold font, or a bold outline
};

/// A picture in memory, an SDL2 surface drawn without a screen. Coordinates are pixels, y down, (0, 0) the
/// upper left corner of the picture; all edges are anti-aliased. Parts outside of the picture, and points
/// that are not finite or farther than 1e6 pixels away, are left out. The same calls give the same pixels
/// with the same SDL, SDL_ttf and FreeType. Different canvases may be used in different threads at once.
class Canvas {
 public:
  /// The font is DejaVu Sans as found at configuration, or the file in the environment variable FULBITO_FONT.
  /// Errors: kIo if SDL or the font is unavailable; kUsage if a side is not 1...16384 or the picture has more
  /// than 64 million pixels.
  static Result<Canvas> create(int width, int height, Colour background);
  /// One that was moved from can only be destroyed or assigned to.
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  /// [px]
  int width() const;
  /// [px]
  int height() const;
  /// `corner` is its upper left one.
  void fillRectangle(Vec2 corner, double width, double height, Colour colour);
  /// Closed by itself; must not cross itself.
  void fillPolygon(std::span<const Vec2> points, Colour colour);
  /// As fillPolygon for a convex one, in either sense; much faster.
  void fillConvex(std::span<const Vec2> points, Colour colour);
  /// A full disc.
  void fillCircle(Vec2 centre, double radius, Colour colour);
  /// A ring around `radius`.
  void circle(Vec2 centre, double radius, double thickness, Colour colour);
  /// With round ends, as `polyline`.
  void line(Vec2 a, Vec2 b, double thickness, Colour colour);
  /// Open; a translucent colour does not add up where it crosses itself.
  void polyline(std::span<const Vec2> points, double thickness, Colour colour);
  /// A trail: a polyline that goes from nothing at its first point to `colour` at its last, and from the
  /// thickness `first` to `last`.
  void fadingLine(std::span<const Vec2> points, double first, double last, Colour colour);
  /// One line of text, `size` [px] from the top of the tallest letter to the lowest, 4...400, rounded to
  /// whole pixels; line breaks become blanks.
  void text(Vec2 baseline, const std::string& utf8, double size, Colour colour,
            TextAlign align = TextAlign::kLeft);
  /// Width [px] that `text` would take.
  double textWidth(const std::string& utf8, double size) const;

  /// As `text`, at fractions of a pixel, so that it can travel with what moves; words that come again and
  /// again are drawn once.
  void label(Vec2 baseline, const std::string& utf8, const TextStyle& style);
  /// Width [px] that `label` would take.
  double labelWidth(const std::string& utf8, const TextStyle& style) const;

  /// Blends one pixel; nothing outside of the picture.
  void fillPixel(int x, int y, Colour colour);
  /// Puts a whole picture with its upper left corner at (x, y), as it is.
  void place(const Canvas& picture, int x, int y);
  /// Takes over the pixels of a picture of the same size; does nothing for one of another.
  void copyFrom(const Canvas& other);
  /// The pixels of a row, 0xAARRGGBB each; `y` must be in the picture.
  std::span<const std::uint32_t> row(int y) const;

  /// The bytes of an 8-bit PNG file; empty when memory runs out.
  std::string png(PngEffort effort) const;
  /// Writes an 8-bit PNG through a temporary file next to it. Errors: kIo naming the file.
  Result<void> writePng(const std::string& file) const;
  /// Colour of a pixel, for tests; transparent black outside of the picture.
  Colour pixel(int x, int y) const;

 private:
  struct Impl;
  explicit Canvas(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
