#include "navigation/methods/hybrid/way_search.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

constexpr double kHalf = 0.0375;  // [m] of the robot's width

/// A wall at x = 0.15 as seen from the left, with an opening from `low` to `high`.
ProvenMap wallWith(double low, double high) {
  ProvenMap map(0.005);
  map.centre({}, 0);
  for (double y = -0.28; y <= 0.28; y += 0.005) {
    if (y > low && y < high) continue;
    for (int i = 0; i < 6; ++i) map.takeIn({{0.05, y}, {1.0, 0.0}, 0.05, true, 0.1}, 1.0);
  }
  return map;
}

/// Where the way crosses the wall.
double crossing(const WaySearch& way) {
  const auto found = std::find_if(way.path().begin(), way.path().end(), [](Vec2 p) { return p.x > 0.15; });
  REQUIRE(found != way.path().end());
  return found->y;
}

}  // namespace

TEST_CASE("the way leads through the middle of an opening", "[unit]") {
  WaySearch way;
  way.search(wallWith(-0.12, -0.02), {}, {0.25, 0.0}, kHalf);
  CHECK(crossing(way) == Approx(-0.07).margin(0.012));
}

TEST_CASE("no way leads through an opening narrower than the robot", "[unit]") {
  WaySearch way;
  const ProvenMap map = wallWith(0.0, 0.06);
  way.search(map, {}, {0.25, 0.0}, kHalf);
  for (const Vec2 place : way.path()) {
    if (std::abs(place.y) < 0.1) CHECK(std::abs(place.x - 0.15) > 0.02);
  }
}

TEST_CASE("a straight face goes on until a sensor has looked at its place", "[unit]") {
  ProvenMap map(0.005);
  map.centre({}, 0);
  const auto face = [&](double from, double to) {
    for (double y = from; y <= to; y += 0.005)
      for (int i = 0; i < 6; ++i) map.takeIn({{0.05, y}, {1.0, 0.0}, 0.05, true, 0.1}, 1.0);
  };
  face(-0.05, 0.27);
  WaySearch unseen;
  unseen.search(map, {}, {0.25, 0.0}, kHalf);
  // Free from the front below -0.10: there the face has ended.
  for (double y = -0.28; y <= -0.10; y += 0.01) map.takeIn({{0.05, y}, {1.0, 0.0}, 0.05, false, 0.3}, 1.0);
  WaySearch seen;
  seen.search(map, {}, {0.25, 0.0}, kHalf);
  CHECK(crossing(seen) < -0.10);
  CHECK(unseen.path().size() > 2);
}

TEST_CASE("a way is worth more where it was seen free from where it comes", "[unit]") {
  // Two openings as far from the straight way; sensors looked through one of them from in front.
  for (const double side : {1.0, -1.0}) {
    ProvenMap map(0.005);
    map.centre({}, 0);
    for (double y = -0.28; y <= 0.28; y += 0.005) {
      if (std::abs(y) > 0.03 && std::abs(y) < 0.15) continue;
      for (int i = 0; i < 6; ++i) map.takeIn({{0.05, y}, {1.0, 0.0}, 0.05, true, 0.1}, 1.0);
    }
    for (double y = -0.14; y <= 0.14; y += 0.01) {
      const Vec2 across{0.0, y > 0.0 ? 1.0 : -1.0}, from = y * side > 0.0 ? Vec2{0.0, y} : Vec2{0.15, 0.0};
      map.takeIn({from, y * side > 0.0 ? Vec2{1.0, 0.0} : across, 0.05, false, 0.25}, 1.0);
    }
    WaySearch way;
    way.search(map, {}, {0.3, 0.0}, kHalf);
    CHECK(crossing(way) * side > 0.03);
  }
}
