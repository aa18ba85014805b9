#include "navigation/followers/wall_zones.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

namespace fulbito {
namespace {

constexpr Twist kWanted{0.7, -0.3};

struct Stage {
  RobotModel robot = test::paperRobot(1.4);
  FieldGeometry field;
  WallZones zones;

  Twist apply(Pose2 pose, Vec2 goal) {
    NavigationScene scene;
    scene.self.pose = pose;
    scene.goal.position = goal;
    scene.field = &field;
    scene.robot = &robot;
    return zones.apply(scene, kWanted);
  }
};

double degrees(double angle) { return angle * math::kPi / 180.0; }

}  // namespace

TEST_CASE("in a wall's zone the wheels get unequal speeds toward the ball, whatever the heading", "[unit]") {
  // Right wall, lower wall and left wall, each with a goal on its left and one on its right.
  const struct {
    Vec2 place, left, right;
  } walls[] = {{{0.67, 0.35}, {-0.2, -0.3}, {0.2, 0.5}},
               {{0.2, -0.58}, {-0.4, 0.2}, {0.5, -0.1}},
               {{-0.68, -0.40}, {0.1, 0.0}, {-0.3, -0.5}}};
  for (const auto& wall : walls) {
    Stage stage;
    for (int heading = -175; heading < 180; heading += 35) {
      CAPTURE(wall.place.x, wall.place.y, heading);
      stage.zones.reset();
      const Twist left = stage.apply({wall.place, degrees(heading)}, wall.left);
      CHECK(left.angular > 0.0);
      // Both wheels turn the same way, and the end that points away from the wall leads.
      CHECK(left.angular * stage.robot.axle_track / 2 < std::abs(left.linear));
      const Vec2 moves = math::unit(degrees(heading)) * left.linear * 0.01;
      CHECK(wallClearance(stage.field, wall.place + moves) >= wallClearance(stage.field, wall.place) - 1e-12);
      stage.zones.reset();
      CHECK(stage.apply({wall.place, degrees(heading)}, wall.right).angular == -left.angular);
    }
  }
}

TEST_CASE("in a corner two zones act one after the other, with opposite senses", "[unit]") {
  Stage stage;
  stage.field.corner = 0.0;
  // Lower right corner with the goal to the upper left: counter-clockwise at the right wall, clockwise at the
  // lower one.
  const Vec2 goal{-0.3, 0.4};
  const double right = stage.apply({{0.70, -0.59}, 0.0}, goal).angular;
  CHECK(right < 0.0);
  // The lower wall is nearer, but the robot is still in the right wall's zone.
  CHECK(stage.apply({{0.66, -0.60}, 0.0}, goal).angular == right);
  CHECK(stage.apply({{0.65, -0.60}, 0.0}, goal).angular == -right);
  CHECK(stage.apply({{0.65, -0.57}, 0.0}, goal).angular == -right);
  const Twist out = stage.apply({{0.65, -0.55}, 0.0}, goal);
  CHECK(out.linear == kWanted.linear);
  CHECK(out.angular == kWanted.angular);
  CHECK_FALSE(stage.zones.active());
}

TEST_CASE("from any heading the rule leads out of a wall's zone, and out of a corner", "[unit]") {
  const RobotModel robot = test::paperRobot(0.8);
  const struct {
    Vec2 place, goal;
  } starts[] = {{{0.68, -0.38}, {-0.2, 0.1}}, {{0.3, 0.57}, {-0.4, -0.1}}, {{-0.63, -0.58}, {0.3, 0.2}}};
  for (const auto& start : starts) {
    for (int heading = -170; heading < 180; heading += 50) {
      CAPTURE(start.place.x, start.place.y, heading);
      auto pilot = makePilot(*parseNavigator("vector-field:wall_escape=zones"));
      REQUIRE(pilot);
      NavigationGoal goal;
      goal.position = start.goal;
      CHECK(
          test::kinematicTrial(**pilot, robot, {}, {start.place, degrees(heading)}, goal, {}, 12.0).reached);
    }
  }
}

TEST_CASE("a goal's mouth has no zone, and its back has", "[unit]") {
  Stage stage;
  CHECK(stage.apply({{0.70, 0.05}, 0.0}, {-0.3, 0.0}).angular == kWanted.angular);
  CHECK(stage.apply({{0.79, 0.05}, 0.0}, {-0.3, 0.3}).linear != kWanted.linear);
}

TEST_CASE("the boundary rule is an option of every method", "[unit]") {
  for (const char* method :
       {"univector:wall_escape=zones", "tangent-field:follower=classic,wall_escape=zones"}) {
    const auto choice = parseNavigator(method);
    REQUIRE(choice);
    CHECK(choice->wall_rule == WallRule::kZones);
    auto pilot = makePilot(*choice);
    Stage stage;
    NavigationScene scene;
    scene.self.pose = {{-0.69, 0.31}, degrees(180.0)};
    scene.goal.position = {0.2, -0.2};
    scene.field = &stage.field;
    scene.robot = &stage.robot;
    (*pilot)->reset();
    WheelSpeeds wheels;
    for (int i = 0; i < 60; ++i) {  // time for the limiter to reach the rule's speeds
      wheels = (*pilot)->drive(scene);
      scene.self.angular_velocity =
          (wheels.right - wheels.left) * stage.robot.wheel_radius / stage.robot.axle_track;
      scene.self.velocity =
          math::unit(scene.self.pose.heading) * ((wheels.right + wheels.left) * stage.robot.wheel_radius / 2);
      ++scene.tick;
    }
    CHECK(wheels.right == Approx(3.0 * wheels.left));  // backward and clockwise
    CHECK(wheels.right < 0.0);
  }
}

}  // namespace fulbito
