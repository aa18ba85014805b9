#include "navigation/methods/reactive/dwa.hpp"

#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/navigator_properties.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {

TEST_CASE("the dynamic window approach keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("dwa");
}

TEST_CASE("the dynamic window approach is safe on corner layouts", "[unit]") {
  for (double speed : {0.6, 1.0, 2.6}) {
    test::SurveyTask task;
    task.speed = speed;
    task.runs = 40;
    const test::Survey survey = test::survey("dwa", task);
    INFO("speed " << speed << ", safe " << survey.safe << " of 40, L " << survey.over_straight);
    CHECK(survey.safe >= 39);
    CHECK(survey.over_straight < 1.10);
  }
}

TEST_CASE("the dynamic window approach stops before a wall that it is sent through", "[unit]") {
  const auto pilot = makePilot(*parseNavigator("dwa"));
  NavigationGoal goal;
  goal.position = {1.5, 0.0};
  for (double speed : {0.6, 2.6}) {
    const auto run =
        test::kinematicTrial(**pilot, test::paperRobot(speed), {}, {{-0.5, 0.0}, 0.0}, goal, {}, 4.0);
    CHECK_FALSE(run.touched);
    CHECK(run.path.back().x > 0.5);
  }
}

TEST_CASE("the dynamic window approach comes to rest at a goal where it shall stop", "[unit]") {
  Dwa dwa;
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.goal.position = {0.1, 0.0};
  scene.goal.stop = true;
  scene.self.velocity = {0.8, 0.0};
  // The remaining way allows at most sqrt(2 * 0.6 * 5 * (0.1 - 0.015)) = 0.71 m/s.
  const Twist slower = forwardKinematics(robot, dwa.plan(scene).wheels);
  CHECK(slower.linear < 0.8);
  CHECK(slower.linear >= 0.8 - 5.0 / 60.0 - 1e-9);
}

TEST_CASE("the dynamic window approach backs out from a wall that it touches", "[unit]") {
  const auto pilot = makePilot(*parseNavigator("dwa"));
  NavigationGoal goal;
  goal.position = {0.0, 0.1};
  const auto run =
      test::kinematicTrial(**pilot, test::paperRobot(1.0), {}, {{0.7124, 0.3}, 0.1}, goal, {}, 6.0);
  CHECK(run.reached);
  CHECK(run.min_clearance > -0.005);  // the robot starts 3.6 mm inside the wall with a corner
}

TEST_CASE("the dynamic window approach gives way to a crossing ball that it would meet", "[unit]") {
  // Both would be at the origin after about one second.
  const auto pilot = makePilot(*parseNavigator("dwa"));
  NavigationGoal goal;
  goal.position = {0.6, 0.0};
  const std::vector<DiscObstacle> crossing = {{{0.0, -0.5}, 0.0335, {0.0, 0.45}}};
  const auto run =
      test::kinematicTrial(**pilot, test::paperRobot(0.6), {}, {{-0.6, 0.0}, 0.0}, goal, crossing);
  CHECK(run.reached);
  CHECK_FALSE(run.touched);

  // The straight reference collides, so there is something to avoid.
  const auto straight = makePilot(*parseNavigator("straight"));
  CHECK(test::kinematicTrial(**straight, test::paperRobot(0.6), {}, {{-0.6, 0.0}, 0.0}, goal, crossing)
            .touched);
}

}  // namespace fulbito
