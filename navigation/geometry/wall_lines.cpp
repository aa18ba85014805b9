#include "navigation/geometry/wall_lines.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

std::array<WallLine, 8> wallLines(const FieldGeometry& field) {
  const double x = field.length / 2, y = field.width / 2, diagonal = 1.0 / std::sqrt(2.0);
  const double cut = (x + y - field.corner) * diagonal;
  return {{{{1.0, 0.0}, x},
           {{-1.0, 0.0}, x},
           {{0.0, 1.0}, y},
           {{0.0, -1.0}, y},
           {{diagonal, diagonal}, cut},
           {{-diagonal, diagonal}, cut},
           {{diagonal, -diagonal}, cut},
           {{-diagonal, -diagonal}, cut}}};
}

std::array<WallLine, 8> wallLines(const FieldGeometry& field, const Pose2& pose) {
  std::array<WallLine, 8> walls = wallLines(field);
  const Vec2 ux = math::unit(pose.heading);
  for (WallLine& wall : walls) {
    wall.clearance -= dot(wall.outward, pose.position);
    wall.outward = intoFrame(ux, wall.outward);
  }
  return walls;
}

}  // namespace fulbito
