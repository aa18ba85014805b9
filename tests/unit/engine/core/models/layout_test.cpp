#include "fulbito/detail/layout.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

// An L of 1 m and 0.5 m at 0.5 m/s: 3 s from end to end.
ObstacleSpec walker(PathEnd end) {
  ObstacleSpec obstacle;
  obstacle.motion = ObstacleMotion::kPath;
  obstacle.path = {{0, 0}, {1, 0}, {1, 0.5}};
  obstacle.speed = 0.5;
  obstacle.path_end = end;
  return obstacle;
}

void checkAt(const ObstacleSpec& obstacle, double time, Vec2 position, Vec2 velocity) {
  CAPTURE(time);
  const Vec2 p = positionAt(obstacle, time), v = velocityAt(obstacle, time);
  CHECK(p.x == Approx(position.x).margin(1e-9));
  CHECK(p.y == Approx(position.y).margin(1e-9));
  CHECK(v.x == Approx(velocity.x).margin(1e-9));
  CHECK(v.y == Approx(velocity.y).margin(1e-9));
}

}  // namespace

TEST_CASE("a bouncing obstacle goes there and back", "[unit]") {
  const ObstacleSpec o = walker(PathEnd::kBounce);
  checkAt(o, 0.0, {0, 0}, {0.5, 0});
  checkAt(o, 1.0, {0.5, 0}, {0.5, 0});
  checkAt(o, 2.0, {1, 0}, {0, 0.5});
  checkAt(o, 2.5, {1, 0.25}, {0, 0.5});
  checkAt(o, 3.0, {1, 0.5}, {0, -0.5});
  checkAt(o, 4.0, {1, 0}, {-0.5, 0});
  checkAt(o, 5.0, {0.5, 0}, {-0.5, 0});
  checkAt(o, 6.0, {0, 0}, {0.5, 0});
  checkAt(o, 6.0 * 100000 + 1.0, {0.5, 0}, {0.5, 0});
}

TEST_CASE("a cycling obstacle returns straight to its first waypoint", "[unit]") {
  ObstacleSpec o = walker(PathEnd::kCycle);
  o.path = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  checkAt(o, 4.0, {1, 1}, {-0.5, 0});
  checkAt(o, 7.0, {0, 0.5}, {0, -0.5});
  checkAt(o, 8.0, {0, 0}, {0.5, 0});
  checkAt(o, -1.0, {0, 0.5}, {0, -0.5});
  checkAt(o, 8.0 * 100000 + 3.0, {1, 0.5}, {0, 0.5});
}

TEST_CASE("a stopping obstacle rests at its last waypoint", "[unit]") {
  const ObstacleSpec o = walker(PathEnd::kStop);
  checkAt(o, -1.0, {0, 0}, {0.5, 0});
  checkAt(o, 2.5, {1, 0.25}, {0, 0.5});
  checkAt(o, 3.0, {1, 0.5}, {0, 0});
  checkAt(o, 1e12, {1, 0.5}, {0, 0});
}

TEST_CASE("waypoints in one place do not hold an obstacle up", "[unit]") {
  ObstacleSpec o = walker(PathEnd::kStop);
  o.path = {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 0.5}, {1, 0.5}};
  checkAt(o, 0.0, {0, 0}, {0.5, 0});
  checkAt(o, 2.0, {1, 0}, {0, 0.5});
  checkAt(o, 3.0, {1, 0.5}, {0, 0});
  o.path = {{0.2, 0.3}, {0.2, 0.3}};
  checkAt(o, 1.0, {0.2, 0.3}, {0, 0});
}

TEST_CASE("an obstacle without a path stays where it is", "[unit]") {
  ObstacleSpec o = walker(PathEnd::kBounce);
  o.pose.position = {0.3, 0.4};
  o.motion = ObstacleMotion::kFixed;
  checkAt(o, 10.0, {0.3, 0.4}, {0, 0});
  o.motion = ObstacleMotion::kPath;
  o.path.clear();
  checkAt(o, 10.0, {0.3, 0.4}, {0, 0});
}

TEST_CASE("the motion stays on the path at any time and matches its velocity", "[unit]") {
  for (PathEnd end : {PathEnd::kBounce, PathEnd::kCycle, PathEnd::kStop}) {
    const ObstacleSpec o = walker(end);
    for (double time : {1e6, 1e9, 1e15, 1e300, 1.7e308, -1e300, std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()}) {
      const Vec2 p = positionAt(o, time);
      CHECK((p.x >= -1e-9 && p.x <= 1 + 1e-9 && p.y >= -1e-9 && p.y <= 0.5 + 1e-9));
      CHECK(norm(velocityAt(o, time)) <= 0.5 + 1e-12);
    }
    for (double time = 0.013; time < 12.0; time += 0.1) {
      if (std::abs(time - std::round(time)) < 0.01) continue;  // turns happen at whole seconds or between
      const Vec2 moved = (positionAt(o, time + 1e-6) - positionAt(o, time)) / 1e-6;
      CHECK(distance(moved, velocityAt(o, time)) < 1e-6);
    }
  }
}

TEST_CASE("validation finds what a layout's obstacles lack", "[unit]") {
  Layout layout;
  CHECK(validate(layout));
  layout.obstacles = {ObstacleSpec{}, walker(PathEnd::kBounce)};
  CHECK(validate(layout));
  layout.obstacles[1].speed = 0.0;
  CHECK(validate(layout).error().message ==
        "obstacle[1].speed = 0 must be above 0 for an obstacle on a path");
  layout.obstacles[1].path = {{0, 0}};
  CHECK(validate(layout).error().message == "obstacle[1].path needs at least 2 waypoints, has 1");
  layout.obstacles[1].path = {{0, 0}, {0, 0}};
  CHECK(validate(layout).error().message == "obstacle[1].path needs two different waypoints");
  layout.obstacles[1].path = {{0, 0}, {0, 13}};
  CHECK(validate(layout).error().message == "obstacle[1].path[1] = [0, 13] is outside -12 ... 12 m");
  layout.obstacles.assign(501, ObstacleSpec{});
  CHECK(validate(layout).error().message ==
        "obstacle[500] is one too many: a layout may have at most 500 obstacles");
}

TEST_CASE("start, goal and obstacles must lie on the field", "[unit]") {
  Layout layout;
  const FieldGeometry field;
  CHECK(validate(layout, field));
  layout.goal = {2, 0};
  CHECK(validate(layout, field).error().message == "goal.position = [2, 0] is outside the field 'vsss-3v3'");
  layout.goal = {0.5, 0};
  layout.obstacles.resize(1);
  layout.obstacles[0].pose.position = {0, 1};
  CHECK(validate(layout, field).error().message ==
        "obstacle[0].position = [0, 1] is outside the field 'vsss-3v3'");
}

}  // namespace fulbito
