#include "experiments/papers/localization/cleaning_route.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito::localization {
namespace {

constexpr double kSame = 1e-3;  // [m] points nearer to each other count as one

/// Converts between the room frame and a frame whose second coordinate is along the stripes.
Vec2 swappedIf(bool swapped, Vec2 p) { return swapped ? Vec2{p.y, p.x} : p; }

void add(std::vector<Vec2>& points, Vec2 p) {
  if (points.empty() || distance(points.back(), p) > kSame) points.push_back(p);
}

/// The stripes from the origin and the way back, in a room whose longer side is its second coordinate.
std::vector<Vec2> stripes(double across, double along, double margin, double spacing) {
  const int gaps = std::max(1, static_cast<int>(std::ceil((across - 2 * margin) / spacing - 1e-9)));
  const double step = (across - 2 * margin) / gaps;
  std::vector<Vec2> points;
  for (int i = 0; i <= gaps; ++i) {
    const double x = margin + i * step;
    const bool there = i % 2 == 0;
    points.push_back({x, there ? margin : along - margin});
    points.push_back({x, there ? along - margin : margin});
  }
  points.push_back({margin, points.back().y});
  points.push_back({margin, margin});
  return points;
}

}  // namespace

CleaningRoute cleaningRoute(const Room& room, const Pose2& start, double margin, double spacing) {
  CleaningRoute route;
  const double right = room.x - margin, top = room.y - margin;
  const Vec2 origin{margin, margin};
  const bool down = std::abs(math::sinCos(start.heading).sin) > 0.5;
  add(route.points, start.position);
  add(route.points, down ? Vec2{start.position.x, margin} : Vec2{margin, start.position.y});
  route.round_begins = route.points.size() - 1;
  add(route.points, origin);
  for (Vec2 corner : {down ? Vec2{margin, top} : Vec2{right, margin}, Vec2{right, top},
                      down ? Vec2{right, margin} : Vec2{margin, top}, origin})
    add(route.points, corner);
  route.round_ends = route.points.size() - 1;
  const bool swapped = room.x > room.y;
  for (Vec2 p : stripes(std::min(room.x, room.y), std::max(room.x, room.y), margin, spacing))
    add(route.points, swappedIf(swapped, p));
  return route;
}

double lengthOf(const CleaningRoute& route) {
  double sum = 0.0;
  for (std::size_t i = 1; i < route.points.size(); ++i) sum += distance(route.points[i - 1], route.points[i]);
  return sum;
}

double distanceFromPart(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 part = to - from;
  const double square = squaredNorm(part);
  const double share = square > 0.0 ? std::clamp(dot(point - from, part) / square, 0.0, 1.0) : 0.0;
  return distance(point, from + part * share);
}

}  // namespace fulbito::localization
