#include "engine/core/models/goal_area.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("the 3v3 goal area has the rule book's arc", "[unit]") {
  const AreaShape area = goalAreaOf(FieldGeometry{});
  CHECK(area.arc_radius == Approx(0.125));
  CHECK(area.arc_centre == Approx(0.075));
  CHECK(area.reach() == Approx(0.20));
  CHECK(goalAreaOf(FieldGeometry{}, false).reach() == Approx(0.15));
  const FieldGeometry large = *loadField("vsss-5v5");
  CHECK(goalAreaOf(large).arc_radius == 0.0);
  CHECK(bigAreaOf(large).depth == 0.35);
  CHECK(bigAreaOf(FieldGeometry{}).half_width == 0.0);
}

TEST_CASE("points in and out of the area", "[unit]") {
  const AreaShape area = goalAreaOf(FieldGeometry{});
  for (const Vec2 in : {Vec2{0.149, 0.34}, Vec2{0.149, -0.34}, Vec2{0.199, 0.0}, Vec2{-0.05, 0.1}}) {
    CHECK(contains(area, in));
  }
  for (const Vec2 out : {Vec2{0.151, 0.11}, Vec2{0.201, 0.0}, Vec2{0.10, 0.36}, Vec2{0.19, 0.06}}) {
    CHECK_FALSE(contains(area, out));
  }
}

TEST_CASE("a goal's frame is a rotation of the other's, and turns back", "[unit]") {
  const FieldGeometry field;
  const Vec2 p{0.61, -0.22};
  CHECK(intoGoalFrame(field, Side::kRight, p) == intoGoalFrame(field, Side::kLeft, -p));
  CHECK(intoGoalFrame(field, Side::kLeft, {-0.75, 0.1}) == Vec2{0.0, 0.1});
  for (const Side side : {Side::kLeft, Side::kRight}) {
    CHECK(distance(outOfGoalFrame(field, side, intoGoalFrame(field, side, p)), p) < 1e-15);
  }
}

TEST_CASE("the distance to an area is that to its nearest point", "[unit]") {
  const AreaShape area = goalAreaOf(FieldGeometry{});
  // Points of the area, a millimetre apart.
  std::vector<Vec2> points;
  for (double x = 0.0; x < 0.2; x += 0.001) {
    for (double y = -0.35; y <= 0.35; y += 0.001) {
      if (contains(area, {x, y})) points.push_back({x, y});
    }
  }
  Rng rng(3, test::kTestStream);
  for (int i = 0; i < 100; ++i) {
    const Vec2 p{rng.uniform(0.0, 0.6), rng.uniform(-0.6, 0.6)};
    double least = 1e9;
    for (const Vec2 q : points) least = std::min(least, distance(p, q));
    CAPTURE(p.x, p.y);
    if (contains(area, p)) {
      CHECK(distanceTo(area, p) <= 0.0);
    } else {
      CHECK(distanceTo(area, p) == Approx(least).margin(0.0015));
    }
  }
}

}  // namespace fulbito
