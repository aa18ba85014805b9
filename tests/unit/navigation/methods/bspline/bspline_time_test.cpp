#include "navigation/methods/bspline/bspline_time.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/navigator_properties.hpp"
#include "tests/support/suite_layouts.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {
namespace {

/// Drives layouts whose seeds differ from the survey's.
test::Survey drive(int runs, double speed, test::LayoutMaker layout) {
  test::SurveyTask task;
  task.layout = std::move(layout);
  task.speed = speed;
  task.first_seed = 40000;
  task.runs = runs;
  return test::survey("bspline-time", task);
}

NavigationScene sceneWith(const FieldGeometry& field, const RobotModel& robot) {
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.self.pose.position = {-0.5, 0.0};
  scene.goal.position = {0.5, 0.0};
  return scene;
}

}  // namespace

TEST_CASE("bspline-time keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("bspline-time");
}

TEST_CASE("bspline-time crosses corner layouts safely and near the limits", "[unit]") {
  const double time_bars[] = {1.03, 1.05, 1.13}, speeds[] = {0.6, 1.0, 2.6};
  for (std::size_t i = 0; i < 3; ++i) {
    const test::Survey out = drive(60, speeds[i], test::cornerLayout);
    CAPTURE(speeds[i]);
    CHECK(out.safe == out.runs);
    CHECK(out.over_shortest <= 1.02);
    CHECK(out.over_bound <= time_bars[i]);
    CHECK(out.clearance >= 0.02);
  }
}

TEST_CASE("bspline-time drives short runs between the balls", "[unit]") {
  for (double speed : {1.0, 2.6}) CHECK(drive(60, speed, test::shortLayout).safe == 60);
}

TEST_CASE("bspline-time arrives with the wanted heading from any heading", "[unit]") {
  for (double speed : {1.0, 2.6}) CHECK(drive(60, speed, test::headingLayout).safe >= 59);
}

TEST_CASE("bspline-time reaches goals beside walls and discs", "[unit]") {
  for (double speed : {1.0, 2.6}) CHECK(drive(60, speed, test::wallLayout).reached == 60);
}

TEST_CASE("bspline-time enters gaps that are narrower than its circumscribed circle", "[unit]") {
  for (double speed : {1.0, 2.6}) {
    const auto narrow = [](std::uint64_t seed) { return test::gapLayout(seed, 1.3 * 0.075); };
    CHECK(drive(60, speed, narrow).safe >= 59);
  }
}

TEST_CASE("bspline-time does not drive into moving discs", "[unit]") {
  for (double speed : {1.0, 2.6}) {
    const test::Survey out = drive(200, speed, test::movingLayout);
    CHECK(out.reached == out.runs);
    CHECK(out.own_fault <= 1);
  }
}

TEST_CASE("bspline-time comes out of a U-trap", "[unit]") {
  const auto trap = [](std::uint64_t) {
    test::CornerLayout layout;
    layout.start = {{-0.1, 0.0}, 0.0};
    layout.goal.position = {0.5, 0.0};
    for (int i = -2; i <= 2; ++i) layout.obstacles.push_back({{0.1, 0.09 * i}, 0.045, {}});
    for (int side : {-1, 1}) {
      for (int i = 1; i <= 2; ++i) layout.obstacles.push_back({{0.1 - 0.09 * i, 0.18 * side}, 0.045, {}});
    }
    return layout;
  };
  CHECK(drive(1, 1.0, trap).safe == 1);
}

TEST_CASE("bspline-time keeps its plan and revision while nothing changes", "[unit]") {
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  NavigationScene scene = sceneWith(field, robot);
  BsplineTime navigator;
  const std::uint64_t first = navigator.plan(scene).revision;
  for (scene.tick = 1; scene.tick < 30; ++scene.tick) CHECK(navigator.plan(scene).revision == first);
  scene.goal.position = {0.5, 0.3};
  CHECK(navigator.plan(scene).revision != first);
}

TEST_CASE("bspline-time goes round a disc that is put in its way", "[unit]") {
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  NavigationScene scene = sceneWith(field, robot);
  BsplineTime navigator;
  navigator.plan(scene);
  const DiscObstacle disc{{0.0, 0.0}, 0.04, {}};
  scene.obstacles = std::span<const DiscObstacle>(&disc, 1);
  Guidance guidance;
  for (scene.tick = 1; scene.tick < 60; ++scene.tick) guidance = navigator.plan(scene);
  double least = 1e9;
  for (Vec2 p : guidance.path) least = std::min(least, distance(p, disc.position));
  CHECK(least > 0.04 + 0.0375 + 0.008);
}

TEST_CASE("bspline-time slows down for discs that leave no way past them", "[unit]") {
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  NavigationScene scene = sceneWith(field, robot);
  scene.self.velocity = {0.9, 0.0};
  scene.self.wheels = {45.0, 45.0};
  std::vector<DiscObstacle> row;
  for (int i = -4; i <= 4; ++i) row.push_back({{-0.25, 0.15 * i}, 0.07, {-0.1, 0.0}});
  scene.obstacles = row;
  BsplineTime navigator;
  const Guidance guidance = navigator.plan(scene);
  CHECK(std::min(guidance.speed_cap, guidance.speeds.front()) < 0.3);
}

TEST_CASE("bspline-time stands still for a touch that it cannot avoid", "[unit]") {
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  NavigationScene scene = sceneWith(field, robot);
  scene.self.velocity = {0.2, 0.0};
  const DiscObstacle disc{{-0.38, 0.0}, 0.05, {-1.5, 0.0}};
  scene.obstacles = std::span<const DiscObstacle>(&disc, 1);
  BsplineTime navigator;
  CHECK(navigator.plan(scene).speed_cap == 0.0);
}

}  // namespace fulbito
