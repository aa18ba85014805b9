#include "replays/render/match/svg_trail.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "replays/render/colours/palette.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kBands = 12;

struct BandPoint {
  Vec2 place;
  double share = 0.0;  ///< position along the trail, 0...1 of its length
};

/// The trail's points, and the points where bands meet.
std::vector<BandPoint> bandPoints(std::span<const Vec2> points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  std::vector<BandPoint> marked;
  if (!(length > 0.5)) return marked;  // [px] a body that stands still leaves no trail
  double so_far = 0.0;
  std::size_t next = 1;
  marked.push_back({points.front(), 0.0});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = distance(points[i - 1], points[i]);
    if (step <= 0.0) continue;
    for (; next < kBands && static_cast<double>(next) / kBands * length < so_far + step; ++next) {
      const double share = static_cast<double>(next) / kBands;
      marked.push_back(
          {points[i - 1] + (points[i] - points[i - 1]) * ((share * length - so_far) / step), share});
    }
    so_far += step;
    marked.push_back({points[i], so_far / length});
  }
  marked.back().share = 1.0;
  return marked;
}

/// Direction of the trail at point `i`.
Vec2 wayAt(const std::vector<BandPoint>& points, std::size_t i) {
  const Vec2 before = points[i == 0 ? 0 : i - 1].place,
             after = points[std::min(i + 1, points.size() - 1)].place;
  return unitOr(after - before, {1.0, 0.0});
}

}  // namespace

void svgFadingLine(SvgText& svg, std::span<const Vec2> points, double first, double last, Colour colour) {
  const std::vector<BandPoint> marked = bandPoints(points);
  std::vector<Vec2> outline, back;
  for (std::size_t i = 0, band = 0; i < marked.size(); ++i) {
    const double thickness = first + (last - first) * marked[i].share;
    const Vec2 aside = perp(wayAt(marked, i)) * (thickness / 2);
    outline.push_back(marked[i].place + aside);
    back.push_back(marked[i].place - aside);
    if (marked[i].share < static_cast<double>(band + 1) / kBands) continue;
    outline.insert(outline.end(), back.rbegin(), back.rend());
    const double opacity = (static_cast<double>(band) + 0.5) / kBands * colour.a;
    svg.polygon(outline, withAlpha(colour, static_cast<std::uint8_t>(std::lround(opacity))));
    outline.assign({marked[i].place + aside});
    back.assign({marked[i].place - aside});
    ++band;
  }
}

}  // namespace fulbito
