#include "navigation/obstacles/proven_map.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

SmoothRange echo(Vec2 apex, Vec2 toward, double range) {
  return {apex, unitOr(toward - apex, {1.0, 0.0}), 0.218, true, range};
}

class Map {
 public:
  Map() { map.reset(), map.centre({}, 0); }
  /// Adds echoes of a point, heard at `apex` by a sensor that points at `toward`.
  void hear(Vec2 apex, Vec2 toward, Vec2 point, int times = 4) {
    for (int i = 0; i < times; ++i) map.takeIn(echo(apex, toward, distance(apex, point)), 1.0);
  }
  bool isOccupied(Vec2 place) const { return map.isOccupied(cell(place)); }
  bool isCertain(Vec2 place) const { return map.isCertain(cell(place)); }
  const ProvenMap::Cell& cell(Vec2 place) const { return map.at(map.cellOf(place.x), map.cellOf(place.y)); }
  ProvenMap map{0.005};
};

}  // namespace

TEST_CASE("cones from two places leave of an arc the point that both hear", "[unit]") {
  Map m;
  const Vec2 point{0.1, 0.01}, phantom{0.0997, -0.012};
  m.hear({0.0, 0.0}, {0.1, 0.0}, point, 8);
  CHECK(m.isOccupied(point));
  CHECK(m.isOccupied(phantom));
  // Another sensor points past the point and hears an echo from far behind it.
  for (int i = 0; i < 4; ++i) m.map.takeIn(echo({0.0, -0.03}, {0.1, -0.02}, 0.2), 1.0);
  CHECK(m.isOccupied(point));
  CHECK_FALSE(m.isOccupied(phantom));
}

TEST_CASE("far echoes make cells occupied, near ones certain", "[unit]") {
  Map m;
  m.hear({-0.1, 0.0}, {0.1, 0.0}, {0.1, 0.0}, 20);
  CHECK(m.isOccupied({0.1, 0.001}));
  CHECK_FALSE(m.isCertain({0.1, 0.001}));
  m.hear({0.02, 0.0}, {0.1, 0.0}, {0.1, 0.0}, 20);
  CHECK(m.isCertain({0.1, 0.001}));
}

TEST_CASE("a certain face is not cleared by a sensor that sees it aslant", "[unit]") {
  const Vec2 point{0.1, 0.0};
  Map m;
  m.hear({0.02, 0.0}, point, point, 20);
  for (int i = 0; i < 10; ++i) m.map.takeIn(echo({0.05, -0.1}, point, 0.25), 1.0);  // 63 degrees off
  CHECK(m.isCertain(point));
  for (int i = 0; i < 10; ++i) m.map.takeIn(echo({0.02, 0.01}, point, 0.25), 1.0);
  CHECK_FALSE(m.isOccupied(point));
}

TEST_CASE("a cell knows from where it was seen free", "[unit]") {
  Map m;
  m.map.takeIn(echo({-0.05, 0.0}, {0.1, 0.0}, 0.25), 1.0);
  const ProvenMap::Cell& cell = m.cell({0.1, 0.0});
  CHECK(ProvenMap::isProven(cell, {-1.0, 0.0}));
  CHECK(ProvenMap::isProven(cell, math::unit(math::kPi + 0.35)));
  CHECK_FALSE(ProvenMap::isProven(cell, {0.0, 1.0}));
  CHECK_FALSE(ProvenMap::isProven(m.cell({-0.1, 0.0}), {-1.0, 0.0}));  // behind the sensor
}

TEST_CASE("the map moves with the robot and forgets what leaves it", "[unit]") {
  Map m;
  m.hear({0.0, 0.0}, {0.1, 0.0}, {0.1, 0.0});
  m.map.centre({0.2, 0.0}, 1);
  CHECK(m.isOccupied({0.1, 0.0}));
  m.map.centre({0.8, 0.0}, 2);
  m.map.centre({0.0, 0.0}, 3);
  CHECK_FALSE(m.isOccupied({0.1, 0.0}));
}
