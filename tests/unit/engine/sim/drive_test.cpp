#include "engine/sim/drive.hpp"

#include <limits>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kStep = 0.01;  // [s]

RobotModel plainRobot() {
  RobotModel robot;
  robot.wheel_radius = 0.02;
  robot.axle_track = 0.08;
  robot.max_wheel_speed = 100.0;
  robot.wheel_acceleration = robot.wheel_braking = 5.0;
  robot.longitudinal_grip = 10.0;
  robot.lateral_grip = 6.0;
  return robot;
}

}  // namespace

TEST_CASE("a wheel pulls with the motor's limit and no further than its command", "[unit]") {
  Drive drive(plainRobot(), kStep, 0.0);
  drive.setCommand({50.0, 50.0});  // 1 m/s
  CHECK(drive.step({0.5, 0.0, 0.0}).forward == Approx(5.0 * kStep));
  CHECK(drive.step({0.97, 0.0, 0.0}).forward == Approx(0.03));
  CHECK(drive.step({1.5, 0.0, 0.0}).forward == Approx(-5.0 * kStep));
  CHECK(drive.step({-0.5, 0.0, 0.0}).forward == Approx(5.0 * kStep));
}

TEST_CASE("wheels that turn against each other turn the body", "[unit]") {
  Drive drive(plainRobot(), kStep, 0.0);
  drive.setCommand({-50.0, 50.0});
  const BodyMotion change = drive.step({});
  CHECK(change.forward == Approx(0.0).margin(1e-12));
  // Each motor gives half of the mass 5 m/s2, at 0.04 m from the middle.
  const RobotModel robot = plainRobot();
  CHECK(change.yaw == Approx(robot.mass * 5.0 * 0.04 / robot.inertia() * kStep));
  CHECK(drive.step({0.0, 0.0, 25.0}).yaw == Approx(0.0).margin(1e-12));  // 1 m/s at each rim already
}

TEST_CASE("a measured yaw acceleration stands for mass and shape", "[unit]") {
  RobotModel robot = plainRobot();
  robot.yaw_acceleration = 100.0;
  Drive drive(robot, kStep, 0.0);
  drive.setCommand({-50.0, 50.0});
  CHECK(drive.step({}).yaw == Approx(100.0 * kStep));
  CHECK(robot.turnAcceleration() == Approx(100.0));
}

TEST_CASE("a wheel that holds its speed helps to move the body that the other one turns", "[unit]") {
  // The right motor pulls with F, the left one keeps its rim at rest: v = (track / 2) w at every moment, and
  // both forces are limited.
  const RobotModel robot = plainRobot();
  const double share = robot.turnShare();
  Drive drive(robot, kStep, 0.0);
  drive.setCommand({0.0, 50.0});
  const BodyMotion change = drive.step({});
  CHECK(change.forward == Approx(change.yaw * robot.axle_track / 2));
  CHECK(change.forward == Approx(5.0 * share / (1.0 + share) * kStep));
}

TEST_CASE("drag slows what speeds up, helps what brakes, and leaves turning alone", "[unit]") {
  RobotModel robot = plainRobot();
  robot.rolling_drag = 2.0;
  robot.wheel_braking = 8.5;  // less than the 9 m/s2 of motors and drag
  Drive drive(robot, kStep, 0.0);
  drive.setCommand({50.0, 50.0});
  CHECK(drive.step({}).forward == Approx(5.0 * kStep));
  // the motors hold the speed against the drag
  CHECK(drive.step({1.0, 0.0, 0.0}).forward == Approx(0.0).margin(1e-6));
  drive.setCommand({});
  CHECK(drive.step({0.5, 0.0, 0.0}).forward == Approx(-8.5 * kStep));
  CHECK(drive.step({0.01, 0.0, 0.0}).forward == Approx(-0.01));
  drive.setCommand({-50.0, 50.0});
  CHECK(drive.step({}).yaw == Approx(robot.mass * 7.0 * 0.04 / robot.inertia() * kStep));
}

TEST_CASE("the spin ratio is of turning in place and does not act on arcs", "[unit]") {
  RobotModel robot = plainRobot();
  robot.wheel_acceleration = robot.wheel_braking = robot.longitudinal_grip = 1e6;  // the rims follow at once
  robot.spin_slow_speed = 0.4;
  robot.spin_slow_ratio = robot.spin_fast_ratio = 0.9;
  robot.spin_fast_speed = 0.8;
  Drive drive(robot, kStep, 0.0);
  const auto yaw = [&](double left, double right) {
    drive.setCommand({left, right});
    // relative to the difference of the wheel speeds
    return drive.step({}).yaw * robot.axle_track / robot.wheel_radius;
  };
  CHECK(yaw(-10.0, 10.0) == Approx(0.9 * 20.0));
  CHECK(yaw(0.0, 20.0) == Approx(20.0));
  CHECK(yaw(10.0, 30.0) == Approx(20.0));
  CHECK(yaw(-5.0, 15.0) == Approx(0.95 * 20.0));  // halfway
}

TEST_CASE("the body drives the wider curve of a robot that slips in curves", "[unit]") {
  RobotModel robot = plainRobot();
  robot.wheel_acceleration = robot.wheel_braking = robot.longitudinal_grip = 1e6;  // the rims follow at once
  robot.curve_widening = 0.5;
  Drive drive(robot, kStep, 0.0);
  drive.setCommand({10.0, 20.0});  // 0.3 m/s at a radius of 0.12 m
  const BodyMotion motion = drive.step({});
  CHECK(motion.forward == Approx(0.3));
  CHECK(motion.forward / motion.yaw == Approx(0.12 + 0.5 * 0.3));
}

TEST_CASE("the tyres resist sideways motion up to their grip", "[unit]") {
  Drive drive(plainRobot(), kStep, 0.0);
  drive.setCommand({});
  CHECK(drive.step({0.0, 0.5, 0.0}).sideways == Approx(-6.0 * kStep));
  CHECK(drive.step({0.0, -0.5, 0.0}).sideways == Approx(6.0 * kStep));
  CHECK(drive.step({0.0, 0.02, 0.0}).sideways == Approx(-0.02));
}

TEST_CASE("a motor stronger than the grip makes the wheel slip and its encoder run on", "[unit]") {
  RobotModel robot = plainRobot();
  robot.wheel_acceleration = robot.wheel_braking = 30.0;
  Drive drive(robot, kStep, 0.0);
  drive.setCommand({50.0, 50.0});
  BodyMotion motion;
  for (int i = 1; i <= 3; ++i) {
    const BodyMotion change = drive.step(motion);
    CHECK(change.forward == Approx(10.0 * kStep));  // the force that the floor transmits
    motion.forward += change.forward;
    CHECK(drive.encoders(motion.forward, motion.yaw).left == Approx(30.0 * kStep * i / robot.wheel_radius));
  }
  for (int i = 0; i < 20; ++i) motion.forward += drive.step(motion).forward;
  CHECK(motion.forward == Approx(1.0));  // the robot has the speed of its rims
  CHECK(drive.encoders(motion.forward, motion.yaw).right == Approx(50.0));
}

TEST_CASE("encoders read the ground's speed while the wheels hold", "[unit]") {
  Drive drive(plainRobot(), kStep, 0.0);
  drive.setCommand({50.0, 50.0});
  drive.step({0.4, 0.0, 2.0});
  const WheelSpeeds read = drive.encoders(0.4, 2.0);
  CHECK(read.left == Approx((0.4 - 0.08) / 0.02));
  CHECK(read.right == Approx((0.4 + 0.08) / 0.02));
}

TEST_CASE("commands are limited, then rounded to the nearest step, away from zero in between", "[unit]") {
  RobotModel robot = plainRobot();
  robot.wheel_acceleration = robot.wheel_braking = robot.longitudinal_grip = 1e6;  // the rims follow at once
  Drive drive(robot, kStep, 0.5);
  const auto reached = [&](double command) {
    drive.setCommand({command, command});
    return drive.step({}).forward / robot.wheel_radius;
  };
  CHECK(reached(10.2) == Approx(10.0));
  CHECK(reached(10.25) == Approx(10.5));
  CHECK(reached(-10.25) == Approx(-10.5));
  CHECK(reached(-10.2) == Approx(-10.0));
  CHECK(reached(0.1) == 0.0);
  CHECK(reached(1e9) == Approx(100.0));
  CHECK(reached(-1e300) == Approx(-100.0));
}

TEST_CASE("a command holds until another one comes, and NaN is none", "[unit]") {
  Drive drive(plainRobot(), kStep, 0.0);
  const double push = 5.0 * kStep, nan = std::numeric_limits<double>::quiet_NaN();
  const auto pushed = [&](double left, double right) {
    drive.setCommand({left, right});
    return drive.step({}).forward;
  };
  for (double sense : {1.0, 1.0, -1.0, -1.0, 1.0})
    CHECK(pushed(50.0 * sense, 50.0 * sense) == Approx(push * sense));
  for (int i = 0; i < 2; ++i) CHECK(pushed(nan, nan) == 0.0);
  CHECK(pushed(50.0, nan) == Approx(pushed(50.0, 0.0)));
  CHECK(pushed(50.0, 50.0) == Approx(push));
}

TEST_CASE("a robot pushed sideways stops within the distance its grip gives", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, faithfulPhysics());
  config.robots[0].velocity = {0.0, 1.0};
  World world = makeWorld(config);
  run(world, {}, 60);
  CHECK(world.state().robots[0].velocity.y == Approx(0.0).margin(1e-6));
  CHECK(world.state().robots[0].pose.position.y == Approx(1.0 / 16).epsilon(0.05));
}
