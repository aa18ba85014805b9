#include "replays/render/canvas/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kFarthest = 1e6;  // [px] largest coordinate that is drawn

bool drawable(Vec2 p) { return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest; }
bool drawableSize(double size) { return size > 0.0 && size <= kFarthest; }

Vec2 lower(Vec2 a, Vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
Vec2 upper(Vec2 a, Vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a, to_p = p - a;
  const double length2 = squaredNorm(along);
  const double t = length2 > 0.0 ? std::clamp(dot(to_p, along) / length2, 0.0, 1.0) : 0.0;
  return norm(to_p - along * t);
}

bool insidePolygon(std::span<const Vec2> points, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const Vec2 a = points[i], b = points[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

double distanceToOutline(std::span<const Vec2> points, Vec2 p) {
  double best = 2 * kFarthest;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    best = std::min(best, distanceToSegment(p, points[j], points[i]));
  }
  return best;
}

/// A share 0...1 as the nearest of 0...255. lround would take half of the time of drawing a shape.
std::uint8_t asByte(double share) {
  return static_cast<std::uint8_t>(static_cast<int>(share * 510.0 + 1.0) / 2);
}

/// Coverage of a pixel by a stroke. A stroke thinner than a pixel covers at most its thickness.
double strokeCoverage(double to_middle, double thickness) {
  return std::min(0.5 + thickness / 2 - to_middle, thickness);
}

}  // namespace

CoverageMask::CoverageMask(int width, int height)
    : width_(width),
      height_(height),
      dirty_{width, height, 0, 0},
      covered_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

CoverageMask::Box CoverageMask::touch(Vec2 low, Vec2 high, double margin) {
  const auto within = [](double value, int limit) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
  };
  const Box box{within(std::floor(low.x - margin), width_), within(std::floor(low.y - margin), height_),
                within(std::floor(high.x + margin) + 1, width_),
                within(std::floor(high.y + margin) + 1, height_)};
  dirty_ = {std::min(dirty_.left, box.left), std::min(dirty_.top, box.top), std::max(dirty_.right, box.right),
            std::max(dirty_.bottom, box.bottom)};
  return box;
}

template <typename Coverage>
void CoverageMask::add(Box box, Coverage coverage) {
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double part = std::clamp(coverage(Vec2{x + 0.5, y + 0.5}), 0.0, 1.0);
      at(x, y) = std::max(at(x, y), asByte(part));
    }
  }
}

void CoverageMask::addRectangle(Vec2 corner, double width, double height) {
  if (!drawable(corner) || !drawableSize(width) || !drawableSize(height)) return;
  const Vec2 end = corner + Vec2{width, height};
  const auto overlap = [](double centre, double low, double high) {
    return std::max(0.0, std::min(centre + 0.5, high) - std::max(centre - 0.5, low));
  };
  add(touch(corner, end, 0.0),
      [&](Vec2 p) { return overlap(p.x, corner.x, end.x) * overlap(p.y, corner.y, end.y); });
}

void CoverageMask::addDisc(Vec2 centre, double radius) {
  if (!drawable(centre) || !drawableSize(radius)) return;
  add(touch(centre, centre, radius + 1.0), [=](Vec2 p) { return 0.5 + radius - distance(p, centre); });
}

void CoverageMask::addRing(Vec2 centre, double radius, double thickness) {
  if (!drawable(centre) || !drawableSize(radius) || !drawableSize(thickness)) return;
  add(touch(centre, centre, radius + thickness / 2 + 1.0),
      [=](Vec2 p) { return strokeCoverage(std::abs(distance(p, centre) - radius), thickness); });
}

void CoverageMask::addStroke(Vec2 a, Vec2 b, double thickness) {
  if (!drawable(a) || !drawable(b) || !drawableSize(thickness)) return;
  // A long slanted stroke fills little of its bounding box. Split into pieces, only pixels near it are
  // visited.
  const double longest = std::max(64.0, 2.0 * thickness);
  const int pieces = std::max(1, static_cast<int>(std::ceil(distance(a, b) / longest)));
  for (int i = 0; i < pieces; ++i) {
    addShortStroke(a + (b - a) * (static_cast<double>(i) / pieces),
                   a + (b - a) * (static_cast<double>(i + 1) / pieces), thickness);
  }
}

void CoverageMask::addShortStroke(Vec2 a, Vec2 b, double thickness) {
  add(touch(lower(a, b), upper(a, b), thickness / 2 + 1.0),
      [=](Vec2 p) { return strokeCoverage(distanceToSegment(p, a, b), thickness); });
}

void CoverageMask::addTaper(const TaperEnd& a, const TaperEnd& b) {
  const double thickest = std::max(a.thickness, b.thickness);
  if (!drawable(a.place) || !drawable(b.place) || !drawableSize(thickest)) return;
  const Vec2 along = b.place - a.place;
  const double length2 = squaredNorm(along);
  add(touch(lower(a.place, b.place), upper(a.place, b.place), thickest / 2 + 1.0), [=](Vec2 p) {
    const Vec2 to_p = p - a.place;
    const double t = length2 > 0.0 ? std::clamp(dot(to_p, along) / length2, 0.0, 1.0) : 1.0;
    const double thickness = a.thickness + (b.thickness - a.thickness) * t;
    return (a.share + (b.share - a.share) * t) *
           std::min(1.0, strokeCoverage(norm(to_p - along * t), thickness));
  });
}

void CoverageMask::addPolygon(std::span<const Vec2> points) {
  if (points.size() < 3 || !std::all_of(points.begin(), points.end(), drawable)) return;
  Vec2 low = points[0], high = points[0];
  for (Vec2 p : points) low = lower(low, p), high = upper(high, p);
  add(touch(low, high, 1.0), [=](Vec2 p) {
    const double to_edge = distanceToOutline(points, p);
    return insidePolygon(points, p) ? 0.5 + to_edge : 0.5 - to_edge;
  });
}

void CoverageMask::addConvex(std::span<const Vec2> points) {
  constexpr std::size_t kMostCorners = 16;
  if (points.size() < 3 || points.size() > kMostCorners) return;
  if (!std::all_of(points.begin(), points.end(), drawable)) return;
  std::array<ConvexEdge, kMostCorners> edges;
  double doubled_area = 0.0;
  Vec2 low = points[0], high = points[0];
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    doubled_area += cross(points[j], points[i]);
    low = lower(low, points[i]), high = upper(high, points[i]);
  }
  const double sense = doubled_area < 0.0 ? -1.0 : 1.0;
  std::size_t count = 0;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const Vec2 along = points[i] - points[j];
    const double length = norm(along);
    if (!(length > 0.0)) continue;
    const Vec2 inward = perp(along) * (sense / length);
    edges[count++] = {inward, 0.5 - dot(inward, points[i])};
  }
  const Box box = touch(low, high, 1.0);
  for (int y = box.top; y < box.bottom; ++y) addConvexRow(y, box, {edges.data(), count});
}

void CoverageMask::addConvexRow(int y, const Box& box, std::span<const ConvexEdge> edges) {
  // Only pixels near the ends of a row have to be tested against all edges: those between `left` and `right`
  // are covered, those before `first` and after `last` are not.
  const auto cut = [&box](double x) {
    return static_cast<int>(std::clamp(x, static_cast<double>(box.left), static_cast<double>(box.right)));
  };
  int first = box.left, last = box.right, left = box.left, right = box.right;
  for (const ConvexEdge& edge : edges) {
    const double slope = edge.inward.x, rest = edge.inward.y * (y + 0.5) + edge.offset;
    if (std::abs(slope) < 1e-9) {
      if (rest <= 0.0) return;
      if (rest < 1.0) right = left;
      continue;
    }
    const double none = -rest / slope - 0.5, all = (1.0 - rest) / slope - 0.5;
    if (slope > 0.0) {
      first = std::max(first, cut(std::floor(none)));
      left = std::max(left, cut(std::ceil(all)));
    } else {
      last = std::min(last, cut(std::ceil(none) + 1.0));
      right = std::min(right, cut(std::floor(all) + 1.0));
    }
  }
  left = std::clamp(left, first, std::max(first, last));
  right = std::clamp(right, left, std::max(left, last));
  const auto ask = [&](int from, int to) {
    for (int x = from; x < to; ++x) {
      double inside = 1.0;
      for (const ConvexEdge& edge : edges) {
        inside = std::min(inside, edge.inward.x * (x + 0.5) + edge.inward.y * (y + 0.5) + edge.offset);
      }
      const auto part = asByte(std::max(0.0, inside));
      at(x, y) = std::max(at(x, y), part);
    }
  };
  ask(first, left);
  for (int x = left; x < right; ++x) at(x, y) = 255;
  ask(right, last);
}

}  // namespace fulbito
