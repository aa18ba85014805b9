#include "fulbito/detail/field_geometry.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

FieldGeometry plainField() {
  FieldGeometry field;
  field.goal_width = field.goal_depth = field.corner = 0.0;
  return field;
}

double signedArea(const std::vector<Vec2>& contour) {
  double twice = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    twice += cross(contour[i], contour[(i + 1) % contour.size()]);
  }
  return twice / 2;
}

double pointToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const double t = std::clamp(dot(p - a, b - a) / squaredNorm(b - a), 0.0, 1.0);
  return distance(p, a + (b - a) * t);
}

}  // namespace

TEST_CASE("the contour runs counter-clockwise around the field, its goals and corners", "[unit]") {
  const FieldGeometry field;
  CHECK(innerContour(field).size() == 16);
  // A rectangle and two goals, minus four triangles.
  CHECK(signedArea(innerContour(field)) == Approx(1.5 * 1.3 + 2 * 0.4 * 0.1 - 4 * 0.07 * 0.07 / 2));
  CHECK(innerContour(plainField()).size() == 4);
  CHECK(signedArea(innerContour(plainField())) == Approx(1.5 * 1.3));
}

TEST_CASE("no stretch of a valid field's contour is empty", "[unit]") {
  FieldGeometry field;
  for (double corner : {0.0, 0.07, 0.4499}) {
    field.corner = corner;
    REQUIRE(validate(field));
    const auto contour = innerContour(field);
    for (std::size_t i = 0; i < contour.size(); ++i) {
      CHECK(distance(contour[i], contour[(i + 1) % contour.size()]) > 0.0);
    }
  }
}

TEST_CASE("wall clearance is the distance to the nearest wall of the closed octagon", "[unit]") {
  FieldGeometry field;
  field.goal_width = field.goal_depth = 0.0;
  field.corner = 0.2;
  const auto contour = innerContour(field);
  for (double x = -0.74; x < 0.75; x += 0.02) {
    for (double y = -0.64; y < 0.65; y += 0.02) {
      const double clearance = wallClearance(field, {x, y});
      if (clearance <= 0.0) continue;
      double nearest = 1e9;
      for (std::size_t i = 0; i < contour.size(); ++i) {
        nearest = std::min(nearest, pointToSegment({x, y}, contour[i], contour[(i + 1) % contour.size()]));
      }
      CHECK(clearance == Approx(nearest).margin(1e-12));
    }
  }
}

TEST_CASE("wall clearance has known values at walls, corners and beyond", "[unit]") {
  const FieldGeometry field;
  CHECK(wallClearance(field, {0, 0}) == Approx(0.65));
  CHECK(wallClearance(field, {0.7, 0}) == Approx(0.05));
  CHECK(wallClearance(field, {0.8, 0}) == Approx(-0.05));
  CHECK(wallClearance(field, {0.75 - 0.035, -0.65 + 0.035}) == Approx(0.0).margin(1e-12));
  CHECK(wallClearance(field, {-0.75, 0.65}) == Approx(-0.07 / std::sqrt(2.0)));
  const Vec2 normal = nearestWallNormal(field, {-0.70, 0.60});
  CHECK(normal.x == Approx(std::sqrt(0.5)));
  CHECK(normal.y == Approx(-std::sqrt(0.5)));
  CHECK(nearestWallNormal(field, {0.7, 0.1}) == Vec2{-1, 0});
  CHECK(nearestWallNormal(field, {0.0, -0.6}) == Vec2{0, 1});
}

TEST_CASE("goals belong to the field, posts and corners do not", "[unit]") {
  const FieldGeometry field;
  CHECK(insideField(field, {0.84, 0.0}));
  CHECK(insideField(field, {-0.80, 0.19}));
  CHECK_FALSE(insideField(field, {0.86, 0.0}));
  CHECK_FALSE(insideField(field, {0.80, 0.21}));
  CHECK_FALSE(insideField(field, {0.74, 0.64}));
  CHECK(insideField(field, {0.79, 0.14}, 0.05));
  CHECK_FALSE(insideField(field, {0.80, 0.16}, 0.05));
  CHECK(insideField(field, {0.86, 0.0}, -0.02));
  CHECK_FALSE(insideField(plainField(), {0.76, 0.0}));
}

TEST_CASE("a point that is not finite is nowhere on the field", "[unit]") {
  const FieldGeometry field;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (Vec2 p : {Vec2{nan, 0}, Vec2{0, nan}, Vec2{inf, 0}, Vec2{0, -inf}, Vec2{inf, nan}}) {
    CHECK_FALSE(insideField(field, p));
    CHECK(wallClearance(field, p) == -inf);
    CHECK(isFinite(nearestWallNormal(field, p)));
  }
}

TEST_CASE("a field whose parts do not fit is refused", "[unit]") {
  FieldGeometry field;
  field.corner = 0.65;
  CHECK(validate(field).error().message ==
        "field.corner = 0.65 must be below half of the shorter side, 0.65");
  field.corner = 0.07, field.goal_width = 1.2;
  CHECK(validate(field).error().message ==
        "field.goal_width = 1.2 must be below the width minus both corners, 1.1600000000000001");
  field.goal_width = 0.4, field.length = std::numeric_limits<double>::quiet_NaN();
  CHECK(validate(field).error().message == "field.length = nan is outside 0.3 ... 20 m");
}

}  // namespace fulbito
