#include "engine/sim/walls.hpp"

namespace fulbito {
namespace {

constexpr double kShortestWall = 1e-3;  // [m] shorter walls are merged

std::vector<Vec2> distinctPoints(const std::vector<Vec2>& contour) {
  std::vector<Vec2> points;
  for (Vec2 p : contour) {
    if (points.empty() || distance(points.back(), p) >= kShortestWall) points.push_back(p);
  }
  while (points.size() > 1 && distance(points.front(), points.back()) < kShortestWall) points.pop_back();
  return points;
}

// One corner of the contour: outward normals of the walls before and after it.
struct Corner {
  Vec2 point;
  Vec2 before;
  Vec2 after;

  bool opensInward() const { return cross(before, after) >= 0.0; }  // false at a goal post
  // The corner of the contour that is moved out by `offset`.
  Vec2 movedOut(double offset) const {
    return point + (before + after) * (offset / (1.0 + dot(before, after)));
  }
};

std::vector<Corner> corners(const std::vector<Vec2>& points) {
  const std::size_t count = points.size();
  std::vector<Corner> result;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 previous = points[(i + count - 1) % count], next = points[(i + 1) % count];
    result.push_back(
        {points[i], -perp(unitOr(points[i] - previous, {})), -perp(unitOr(next - points[i], {}))});
  }
  return result;
}

}  // namespace

std::vector<WallOutline> wallOutlines(const FieldGeometry& field, double shift) {
  const std::vector<Corner> all = corners(distinctPoints(innerContour(field)));
  std::vector<WallOutline> walls;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Corner &from = all[i], &to = all[(i + 1) % all.size()];
    const Vec2 inner_from = from.movedOut(shift), inner_to = to.movedOut(shift);
    const Vec2 out = from.after * field.wall_thickness;
    const double reach = shift + field.wall_thickness;
    const Vec2 outer_from = from.opensInward() ? from.movedOut(reach) : inner_from + out;
    const Vec2 outer_to = to.opensInward() ? to.movedOut(reach) : inner_to + out;
    walls.push_back({inner_from, outer_from, outer_to, inner_to});
  }
  return walls;
}

Vec2 inward(const WallOutline& wall) { return perp(unitOr(wall[3] - wall[0], {})); }

bool pushesInward(Vec2 inward, Vec2 normal) {
  constexpr double kAlong = -0.1;  // a goal post also pushes along the wall's face
  return dot(inward, normal) >= kAlong;
}

}  // namespace fulbito
