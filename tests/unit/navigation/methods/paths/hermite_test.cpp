#include "navigation/methods/paths/hermite.hpp"

#include "navigation/geometry/polyline.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/navigator_properties.hpp"

namespace fulbito {

TEST_CASE("hermite keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("hermite");
}

TEST_CASE("a Hermite segment has the textbook's middle and end directions", "[unit]") {
  std::vector<Vec2> points{{0.0, 0.0}};
  appendHermite({0.0, 0.0}, {0.0, 2.0}, {1.0, 0.0}, {0.0, -2.0}, 1.0, points);
  REQUIRE(points.size() == 9);
  // H(1/2) = (a + b) / 2 + (da - db) / 8.
  CHECK(points[4].x == Approx(0.5));
  CHECK(points[4].y == Approx(0.5));
  CHECK(points[8] == Vec2{1.0, 0.0});
  points.assign(1, {0.0, 0.0});
  appendHermite({0.0, 0.0}, {1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}, 0.01, points);
  for (Vec2 p : points) CHECK(p.x == Approx(p.y).margin(1e-15));
}

TEST_CASE("the Hermite path keeps its clearance", "[unit]") {
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  Hermite hermite({});
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const test::CornerLayout layout = test::cornerLayout(seed);
    const NavigationScene scene = test::sceneOf(layout, field, robot);
    hermite.reset();
    const auto path = hermite.plan(scene).path;
    CHECK(path.front() == layout.start.position);
    CHECK(path.back() == layout.goal.position);
    for (const DiscObstacle& o : layout.obstacles) {
      CHECK(distanceToPath(path, o.position) >= o.radius + robot.circumradius() + 0.01 - 1e-9);
    }
  }
  CHECK(hermite.counts().plans == 100);
  CHECK(hermite.counts().tangent == 0);
}

}  // namespace fulbito
