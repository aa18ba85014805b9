// A robot that pitches on its supports, alone on a wide field.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

RobotModel level(RobotModel robot) {
  robot.mass_height = 0.0;
  return robot;
}

World moving(const RobotModel& robot, double speed, double yaw_rate) {
  WorldConfig config = loneRobot(robot, readEachStep(standardPhysics()));
  config.robots[0].velocity = {speed, 0.0};
  config.robots[0].angular_velocity = yaw_rate;
  return makeWorld(config);
}

double yawAfter(const RobotModel& robot, double speed, WheelSpeeds command, int steps) {
  World world = moving(robot, speed, 6.0);
  run(world, command, steps);
  return world.state().robots[0].angular_velocity;
}

double speedAfter(const RobotModel& robot, double speed, WheelSpeeds command, int steps) {
  World world = moving(robot, speed, 0.0);
  run(world, command, steps);
  return world.state().robots[0].velocity.x;
}

}  // namespace

TEST_CASE("a robot that brakes hard lifts its wheels, which then do not steer", "[unit]") {
  const RobotModel robot = firasimPreset().robot;
  const WheelSpeeds back{0.0, -10.0};
  CHECK(yawAfter(level(robot), 0.4, back, 9) < 1.0);  // of 6 rad/s
  CHECK(yawAfter(robot, 0.4, back, 9) > 5.0);
}

TEST_CASE("the wheels come down again, and the robot follows its command", "[unit]") {
  const RobotModel robot = firasimPreset().robot;
  CHECK(std::abs(speedAfter(robot, 0.7, {}, 60)) < 1e-3);
  const double back = speedAfter(robot, 0.5, {-10.0, -10.0}, 100);
  CHECK(back == Approx(-0.2).epsilon(0.01));
  CHECK(yawAfter(robot, 0.5, {-8.0, -12.0}, 120) == Approx(-0.08 / 0.08).epsilon(0.01));
}

TEST_CASE("a robot that swings back from its support is sooner on its way", "[unit]") {
  const RobotModel robot = firasimPreset().robot;
  const WheelSpeeds back{-40.0, -40.0};
  const double tilted = speedAfter(robot, 0.35, back, 14), flat = speedAfter(level(robot), 0.35, back, 14);
  CHECK(flat < 0.0);
  CHECK(tilted < flat - 0.05);
}

TEST_CASE("a robot that speeds up, spins and drives curves stays level", "[unit]") {
  const RobotModel robot = firasimPreset().robot;
  for (const WheelSpeeds command :
       {WheelSpeeds{30.0, 30.0}, WheelSpeeds{-25.0, 25.0}, WheelSpeeds{15.0, 45.0}}) {
    CAPTURE(command.left, command.right);
    World with = moving(robot, 0.0, 0.0), without = moving(level(robot), 0.0, 0.0);
    run(with, command, 100);
    run(without, command, 100);
    const RobotState a = with.state().robots[0], b = without.state().robots[0];
    CHECK(a.pose.position.x == b.pose.position.x);
    CHECK(a.pose.heading == b.pose.heading);
    CHECK(a.angular_velocity == b.angular_velocity);
  }
}

TEST_CASE("a pitching robot stays finite, whatever its supports are made of", "[unit]") {
  for (const double sink : {0.0, 1e-6, 1e-3}) {
    for (const double settling : {0.0, 0.001, 0.1}) {
      RobotModel robot = firasimPreset().robot;
      robot.support_sink = sink;
      robot.support_settling = settling;
      robot.rim_mass = 0.0;
      World world = moving(robot, 1.5, 10.0);
      for (int i = 0; i < 40; ++i) {
        const double sense = i % 2 == 0 ? -1.0 : 1.0;
        run(world, {50.0 * sense, 40.0 * sense}, 11);
        const RobotState state = world.state().robots[0];
        CAPTURE(sink, settling, i);
        REQUIRE(norm(state.velocity) < 4.0);
        REQUIRE(std::abs(state.angular_velocity) < 80.0);
      }
    }
  }
}
