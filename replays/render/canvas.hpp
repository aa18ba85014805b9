#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "engine/core/result.hpp"
#include "engine/core/vec2.hpp"

namespace fulbito {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
};

enum class TextAlign { kLeft, kCentre, kRight };

/// A picture in memory, drawn by SDL2 without a screen. Coordinates are pixels, y down, anti-aliased where it
/// shows.
class Canvas {
 public:
  /// Errors: kIo when SDL or the font cannot be had.
  static Result<Canvas> create(int width, int height, Colour background);
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  int width() const;
  int height() const;
  void fillRectangle(Vec2 corner, double width, double height, Colour colour);
  void fillPolygon(std::span<const Vec2> points, Colour colour);
  void fillCircle(Vec2 centre, double radius, Colour colour);
  void circle(Vec2 centre, double radius, double thickness, Colour colour);
  void line(Vec2 a, Vec2 b, double thickness, Colour colour);
  void polyline(std::span<const Vec2> points, double thickness, Colour colour);
  void text(Vec2 baseline, const std::string& utf8, double size, Colour colour,
            TextAlign align = TextAlign::kLeft);
  /// Width [px] that `text` would take.
  double textWidth(const std::string& utf8, double size) const;

  /// Writes an 8-bit PNG by way of a temporary file beside it. Errors: kIo naming the file.
  Result<void> writePng(const std::string& file) const;
  /// Colour of a pixel, for tests.
  Colour pixel(int x, int y) const;

 private:
  struct Impl;
  explicit Canvas(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
