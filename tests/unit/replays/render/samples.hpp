#pragma once

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/field/bar_chart.hpp"
#include "replays/render/match/match_plan.hpp"

namespace fulbito::test {

/// A path from the layout's start to its goal that bulges sideways by `bulge` [m], with waves of `waves` [m].
inline DrawnPath samplePath(const Layout& layout, const std::string& label, double bulge,
                            double waves = 0.0) {
  constexpr int kTicks = 120;
  DrawnPath path{
      label, fmt::format("{:.2f} s, {:.2f} m", 1.9 + std::abs(bulge), 1.6 + std::abs(bulge)), {}, {}, false};
  const Vec2 way = layout.goal - layout.start.position, side = perp(unitOr(way, {1.0, 0.0}));
  for (int i = 0; i <= kTicks; ++i) {
    const double s = static_cast<double>(i) / kTicks;
    const double out = bulge * math::sin(math::kPi * s) + waves * math::sin(5 * math::kPi * s);
    path.points.push_back(layout.start.position + way * s + side * out);
  }
  return path;
}

inline ObstacleSpec disc(Vec2 position) {
  ObstacleSpec obstacle;
  obstacle.pose.position = position;
  return obstacle;
}

/// A picture of the 3v3 field from corner to corner past four balls, without paths.
inline FieldPicture cornerPicture() {
  FieldPicture picture;
  picture.title = "Corner to corner past four balls";
  picture.layout.start = {{-0.63, -0.53}, 0.69921};
  picture.layout.goal = {0.63, 0.53};
  for (Vec2 p : {Vec2{-0.33, -0.20}, Vec2{-0.10, -0.16}, Vec2{0.16, 0.18}, Vec2{0.36, 0.24}}) {
    picture.layout.obstacles.push_back(disc(p));
  }
  return picture;
}

/// The pixel of a place on the field in a match picture.
inline Vec2 pixelOf(const MatchPicture& picture, Vec2 place) {
  const MatchPlan plan = planOf(picture.spec());
  return plan.centre + Vec2{place.x, -place.y} * plan.pixels_per_metre;
}

inline bool same(Colour a, Colour b) { return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a; }

/// The number of pixels in the rectangle with exactly this colour.
inline int count(const Canvas& canvas, Colour colour, int left, int top, int right, int bottom) {
  int found = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) found += same(canvas.pixel(x, y), colour) ? 1 : 0;
  }
  return found;
}

inline int count(const Canvas& canvas, Colour colour) {
  return count(canvas, colour, 0, 0, canvas.width(), canvas.height());
}

inline bool equal(const Canvas& a, const Canvas& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (!same(a.pixel(x, y), b.pixel(x, y))) return false;
    }
  }
  return true;
}

}  // namespace fulbito::test
