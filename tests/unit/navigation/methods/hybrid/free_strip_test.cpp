#include "navigation/methods/hybrid/free_strip.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

/// Makes the cell at `place` occupied, as heard from the side of the origin.
void put(ProvenMap& map, Vec2 place) {
  const Vec2 apex = place - unitOr(place, {1.0, 0.0}) * 0.03;
  for (int i = 0; i < 4; ++i)
    map.takeIn({apex, unitOr(place - apex, {1.0, 0.0}), 0.218, true, distance(apex, place)}, 1.0);
}

}  // namespace

TEST_CASE("the widest strip stands square to the line between two posts", "[unit]") {
  for (const double turn : {-0.4, 0.0, 0.3}) {
    ProvenMap map(0.005);
    map.centre({}, 0);
    const Vec2 axis = math::unit(turn);
    put(map, perp(axis) * 0.05), put(map, perp(axis) * -0.05);
    StripFinder finder;
    const auto strip = finder.find(map, {}, {1.0, 0.0}, 1.0);
    REQUIRE(strip);
    CHECK(strip->width == Approx(0.1).margin(0.012));
    CHECK(std::abs(strip->aside({})) < 0.006);
    CHECK(dot(strip->axis, axis) > 0.99);
  }
}

TEST_CASE("between parallel walls the strip runs along them, from their front to their end", "[unit]") {
  ProvenMap map(0.005);
  map.centre({}, 0);
  for (int i = -6; i <= 6; ++i) {
    put(map, {0.005 * i, 0.0525}), put(map, {0.005 * i, -0.0475});
  }
  StripFinder finder;
  const auto strip = finder.find(map, {}, math::unit(0.2), 1.0);
  REQUIRE(strip);
  CHECK(std::abs(strip->axis.y) < 0.08);
  CHECK(strip->entry < -0.02);
  CHECK(strip->exit > 0.02);
}

TEST_CASE("there is no strip without something on both sides", "[unit]") {
  ProvenMap map(0.005);
  map.centre({}, 0);
  put(map, {0.0, 0.05});
  StripFinder finder;
  CHECK_FALSE(finder.find(map, {}, {1.0, 0.0}, 1.0));
}

TEST_CASE("the exit of a strip moves on as long as something stands beside the robot", "[unit]") {
  ProvenMap map(0.005);
  map.centre({}, 0);
  for (int i = -4; i <= 40; ++i) {
    const Vec2 apex{0.005 * i, 0.02};
    for (int k = 0; k < 4; ++k) map.takeIn({apex, {0.0, 1.0}, 0.1, true, 0.0325}, 1.0);
  }
  FreeStrip strip{{}, {1.0, 0.0}, 0.095, -0.02, 0.05};
  StripFinder::prolong(map, {0.05, 0.0}, 0.05, 1.0, strip);
  CHECK(strip.exit == Approx(0.1).margin(0.006));
  StripFinder::prolong(map, {0.18, 0.0}, 0.05, 1.0, strip);
  CHECK(strip.exit == Approx(0.2).margin(0.006));
  StripFinder::prolong(map, {0.28, 0.0}, 0.05, 1.0, strip);
  CHECK(strip.exit == Approx(0.2).margin(0.006));
}
