#pragma once

#include <span>
#include <string>

#include "replays/render/colours/match_style.hpp"
#include "replays/render/match/match_plan.hpp"

namespace fulbito {

/// Elements of an SVG picture, one line each. Coordinates are pixels.
class SvgText {
 public:
  void rectangle(Vec2 corner, double width, double height, Colour fill);
  void polygon(std::span<const Vec2> points, Colour fill);
  void circle(Vec2 centre, double radius, Colour fill);
  void ring(Vec2 centre, double radius, double thickness, Colour stroke);
  /// A line with round ends.
  void polyline(std::span<const Vec2> points, double thickness, Colour stroke);
  void text(Vec2 baseline, const std::string& utf8, const TextStyle& style);
  void raw(const std::string& line) { text_ += line + '\n'; }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

/// Writes floor, walls and lines.
void svgField(SvgText& svg, const MatchPlan& plan, const FieldGeometry& field, const FieldColours& colours);

/// The pixel of a place [m] on the field.
inline Vec2 pixelOf(const MatchPlan& plan, Vec2 place) {
  return plan.centre + Vec2{place.x, -place.y} * plan.pixels_per_metre;
}

}  // namespace fulbito
