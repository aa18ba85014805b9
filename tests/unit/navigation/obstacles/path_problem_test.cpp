#include "navigation/obstacles/path_problem.hpp"

#include "navigation/methods/paths/replan_monitor.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {

TEST_CASE("the meeting time is where the robot and the obstacle come together", "[unit]") {
  // Head on: 1 m apart, closing at 0.5 + 1.0.
  CHECK(meetingTime({{1.0, 0.0}, 0.03, {-0.5, 0.0}}, {}, 1.0, 9.0) == Approx(1.0 / 1.5));
  // The obstacle moves away, slower and faster than the robot.
  CHECK(meetingTime({{1.0, 0.0}, 0.03, {0.5, 0.0}}, {}, 1.0, 9.0) == Approx(2.0));
  CHECK(meetingTime({{1.0, 0.0}, 0.03, {1.5, 0.0}}, {}, 1.0, 9.0) == 9.0);
  // Across: the obstacle goes 0.6 while the robot goes 1.0 along the long side of a 3-4-5 triangle.
  CHECK(meetingTime({{0.8, 0.0}, 0.03, {0.0, 0.6}}, {}, 1.0, 9.0) == Approx(1.0));
  CHECK(meetingTime({{1.0, 0.0}, 0.03, {0.5, 0.0}}, {}, 1.0, 0.3) == 0.3);
  CHECK(meetingTime({{0.0, 0.0}, 0.03, {0.0, 0.0}}, {}, 0.0, 0.3) == 0.3);
}

TEST_CASE("obstacles at rest stay, moving ones are where they will be met", "[unit]") {
  const RobotModel robot = test::paperRobot(1.25);
  const FieldGeometry field;
  NavigationScene scene;
  scene.robot = &robot;
  scene.field = &field;
  const std::vector<DiscObstacle> obstacles{{{0.5, 0.2}, 0.03, {0.0, 0.0}}, {{0.3, 0.0}, 0.04, {-0.5, 0.0}}};
  scene.obstacles = obstacles;
  std::vector<Circle> bodies;
  predictObstacles(scene, 1.0, bodies);
  REQUIRE(bodies.size() == 2);
  CHECK(bodies[0].centre == Vec2{0.5, 0.2});
  // The prediction assumes 0.8 of the robot's top speed: 0.3 m at 1.0 + 0.5 m/s.
  CHECK(bodies[1].centre.x == Approx(0.2));
  CHECK(bodies[1].radius == 0.04);
}

TEST_CASE("the guard keeps paths out of discs and off walls, but lets a robot out of them", "[unit]") {
  const FieldGeometry field;
  PathGuard guard;
  const std::vector<Circle> bodies{{{0.0, 0.0}, 0.03}};
  const Vec2 start{-0.5, 0.0}, goal{0.5, 0.0};
  guard.prepare(start, goal, bodies, 0.05, 0.02, field);
  CHECK_FALSE(guard.clear(std::vector<Vec2>{start, goal}));  // between its points
  CHECK(guard.clear(std::vector<Vec2>{start, {0.0, 0.25}, goal}));
  CHECK_FALSE(guard.clear(std::vector<Vec2>{start, {0.0, 0.099}, goal}));
  CHECK(guard.clearAt({0.0, 0.1001}));
  CHECK_FALSE(guard.clearAt({0.0, 0.0999}));
  CHECK(guard.insideWalls(std::vector<Vec2>{start, {0.0, 0.599}, goal}));
  CHECK_FALSE(guard.insideWalls(std::vector<Vec2>{start, {0.0, 0.601}, goal}));
  // A start 9 cm from the disc's centre leaves a radius of 8 cm, and one 7 cm from it a radius of 7 cm.
  guard.prepare({-0.09, 0.0}, goal, bodies, 0.05, 0.02, field);
  CHECK(guard.clearAt({0.0, 0.0801}));
  CHECK_FALSE(guard.clearAt({0.0, 0.0799}));
  guard.prepare({-0.07, 0.0}, goal, bodies, 0.05, 0.02, field);
  CHECK(guard.clearAt({-0.07, 0.0}));
  CHECK_FALSE(guard.clearAt({0.0, 0.0699}));
  // A path may leave a start 4 cm from a wall along that wall, but must not be as close farther on.
  guard.prepare({0.0, 0.61}, goal, {}, 0.05, 0.02, field);
  CHECK(guard.insideWalls(std::vector<Vec2>{{0.0, 0.61}, {0.05, 0.61}}));
  CHECK_FALSE(guard.insideWalls(std::vector<Vec2>{{0.0, 0.61}, {0.2, 0.61}}));
}

TEST_CASE("a path is out of date when the scene has changed or the robot strays", "[unit]") {
  NavigationScene scene;
  scene.goal.position = {1.0, 0.0};
  const std::vector<Vec2> path{{0.0, 0.0}, {1.0, 0.0}};
  std::vector<Circle> obstacles{{{0.5, 0.3}, 0.03}};
  ReplanMonitor monitor;
  CHECK(monitor.due(scene, obstacles, path));
  monitor.planned(scene, obstacles);
  CHECK_FALSE(monitor.due(scene, obstacles, path));
  scene.self.pose.position = {0.4, 0.019};
  CHECK_FALSE(monitor.due(scene, obstacles, path));
  scene.self.pose.position = {0.4, 0.021};
  CHECK(monitor.due(scene, obstacles, path));
  scene.self.pose.position = {0.4, 0.0};
  obstacles[0].centre.y += 0.0019;
  CHECK_FALSE(monitor.due(scene, obstacles, path));
  obstacles[0].centre.y += 0.0002;
  CHECK(monitor.due(scene, obstacles, path));
  monitor.planned(scene, obstacles);
  scene.goal.heading = 1.0;
  CHECK(monitor.due(scene, obstacles, path));
  monitor.planned(scene, obstacles);
  scene.goal.position.x += 0.003;
  CHECK(monitor.due(scene, obstacles, path));
  monitor.planned(scene, obstacles);
  obstacles.push_back({{0.0, -0.5}, 0.03});
  CHECK(monitor.due(scene, obstacles, path));
}

}  // namespace fulbito
