#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "navigation/geometry/polyline.hpp"
#include "navigation/methods/curvature/double_curvature.hpp"
#include "navigation/methods/curvature/single_curvature.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/navigator_properties.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

FieldGeometry hall() {
  FieldGeometry field;
  field.length = field.width = 20.0;
  return field;
}

/// A scene with the robot at the origin facing along y, as in Choi & Lee (2005).
NavigationScene paperScene(const FieldGeometry& field, const RobotModel& robot, Vec2 goal) {
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.self.pose.heading = math::kPi / 2;
  scene.goal.position = goal;
  return scene;
}

/// Number of arrivals from many poses, including some with the goal behind the robot.
int arrivals(const char* navigator, bool with_heading, const RobotModel& robot) {
  const auto pilot = makePilot(*parseNavigator(navigator));
  int arrived = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed, test::kTestStream, 2005);
    const Pose2 start{{rng.uniform(-0.55, 0.55), rng.uniform(-0.45, 0.45)}, rng.uniform(-3.14, 3.14)};
    NavigationGoal goal;
    goal.position = {rng.uniform(-0.55, 0.55), rng.uniform(-0.45, 0.45)};
    if (with_heading) goal.heading = rng.uniform(-3.14, 3.14), goal.stop = true;
    arrived += test::kinematicTrial(**pilot, robot, FieldGeometry{}, start, goal, {}).reached ? 1 : 0;
  }
  return arrived;
}

}  // namespace

TEST_CASE("the navigators of constant curvature keep what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("single-curvature");
  test::checkNavigatorProperties("double-curvature:detour=4");
}

TEST_CASE("single-curvature drives the arc of Choi & Lee", "[unit]") {
  const FieldGeometry field = hall();
  const RobotModel robot;
  SingleCurvature navigator({});
  const auto path = navigator.plan(paperScene(field, robot, {5.0, 4.0})).path;
  CHECK(polylineLength(path) == Approx(7.348).epsilon(1e-4));
  for (const Vec2 p : path) CHECK(distance(p, {4.1, 0.0}) == Approx(4.1));
}

TEST_CASE("double-curvature goes through the point of inflection and keeps the heading", "[unit]") {
  const FieldGeometry field = hall();
  const RobotModel robot;
  DoubleCurvature navigator({});
  const auto path = navigator.plan(paperScene(field, robot, {5.0, 4.0})).path;
  CHECK(polylineLength(path) == Approx(7.348).epsilon(1e-4));
  CHECK(distanceToPath(path, {2.5, 2.0}) < 1e-9);
  CHECK(math::angleOf(path.back() - path[path.size() - 2]) == Approx(math::kPi / 2).epsilon(0.01));
}

TEST_CASE("a curve that is too long or leaves the field gives way to a line", "[unit]") {
  FieldGeometry field = hall();
  const RobotModel robot;
  SingleCurvature navigator({});
  CHECK(navigator.plan(paperScene(field, robot, {0.1, -5.0})).path.size() == 2);
  navigator.reset();
  CHECK(navigator.plan(paperScene(field, robot, {0.0, -5.0})).path.size() == 2);  // straight behind
  navigator.reset();
  CHECK(navigator.plan(paperScene(field, robot, {9.0, 4.0})).path.size() > 2);
  field.width = 10.0;  // the arc rises to 5.4 m
  navigator.reset();
  CHECK(navigator.plan(paperScene(field, robot, {9.0, 4.0})).path.size() == 2);
}

TEST_CASE("a curve is kept while the robot is on it, whatever obstacles do", "[unit]") {
  const FieldGeometry field = hall();
  const RobotModel robot;
  SingleCurvature navigator({});
  NavigationScene scene = paperScene(field, robot, {5.0, 4.0});
  const std::uint64_t revision = navigator.plan(scene).revision;
  const std::vector<DiscObstacle> obstacles{{{2.0, 3.0}, 0.2, {0.1, 0.0}}};
  scene.obstacles = obstacles;
  scene.self.pose = poseAt(arcThrough(scene.self.pose, {5.0, 4.0}), 2.0);
  CHECK(navigator.plan(scene).revision == revision);
  scene.self.pose.position.x += 0.05;
  CHECK(navigator.plan(scene).revision > revision);
}

TEST_CASE("robots of constant curvature arrive from everywhere", "[unit]") {
  RobotModel robot;
  CHECK(arrivals("single-curvature", false, robot) == 60);
  CHECK(arrivals("double-curvature", false, robot) == 60);
  CHECK(arrivals("single-curvature", true, robot) == 60);
  CHECK(arrivals("double-curvature", true, robot) == 60);
}

}  // namespace fulbito
