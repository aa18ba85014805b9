#include "navigation/followers/limiter.hpp"

#include <cmath>

#include "engine/core/models/spin_ratio.hpp"
#include "engine/sim/drive.hpp"
#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

namespace fulbito {

TEST_CASE("the limiter gives the yaw rate the acceleration budget first", "[unit]") {
  RobotModel robot = test::paperRobot(2.6);
  const double dt = 1.0 / 60.0;
  const Twist limited = limitTwist(robot, {1.0, 0.0}, {2.6, 100.0}, dt);
  // By mass and shape, turning has more acceleration than the wheels' rims have straight ahead.
  CHECK(limited.angular == Approx(robot.turnAcceleration() * dt));
  CHECK(limited.angular > 2.0 * 5.0 * dt / 0.068);
  CHECK(limited.linear == Approx(1.0));
}

TEST_CASE("the limiter keeps the yaw rate at wheel saturation and lowers the speed", "[unit]") {
  RobotModel robot = test::paperRobot(1.0);
  const Twist limited = limitTwist(robot, {1.0, 0.0}, {1.0, 2.0}, 1.0 / 60.0);
  CHECK(limited.angular == Approx(2.0));
  CHECK(limited.linear == Approx(1.0 - 2.0 * 0.034));
}

TEST_CASE("the limiter slows down by the braking of the motors", "[unit]") {
  RobotModel robot = test::paperRobot(2.6);
  robot.wheel_acceleration = 1.0;
  robot.wheel_braking = 6.0;
  const double dt = 1.0 / 60.0;
  CHECK(limitTwist(robot, {0.5, 0.0}, {2.0, 0.0}, dt).linear == Approx(0.5 + 1.0 * dt));
  CHECK(limitTwist(robot, {0.5, 0.0}, {-2.0, 0.0}, dt).linear == Approx(0.5 - 6.0 * dt));
  CHECK(limitTwist(robot, {-0.5, 0.0}, {2.0, 0.0}, dt).linear == Approx(-0.5 + 6.0 * dt));
  CHECK(limitTwist(robot, {-0.5, 0.0}, {-2.0, 0.0}, dt).linear == Approx(-0.5 - 1.0 * dt));
}

TEST_CASE("a limited command slows every spin down as hard as the motors can", "[unit]") {
  for (const char* name : {"firasim", "vsss"}) {
    const RobotModel robot = steady(loadRobot(name)->robot);
    const double half_track = robot.axle_track / 2, dt = 1.0 / 60.0;
    const SpinRatio ratio(robot);
    for (double spin = 1.0; spin < 60.0; spin += 1.0) {
      CAPTURE(name, spin);
      const double command = limitTwist(robot, {0.0, spin}, {0.0, -60.0}, dt).angular;
      const double reached = command * ratio.at(std::abs(command) * half_track);
      CHECK(reached < spin - 0.9 * robot.turnAcceleration() * dt);
      if (spin * half_track > robot.maxSpeed()) continue;  // the wheels' top speed limits the command
      const double slowing = ratio.slowingCommandFor({0.0, spin});
      CHECK(command == Approx(slowing - robot.turnAcceleration() * dt));
      // Commands between the two neither slow nor speed up, and pass as they are.
      CHECK(limitTwist(robot, {0.0, spin}, {0.0, (slowing + spin) / 2}, dt).angular ==
            Approx((slowing + spin) / 2));
    }
  }
}

TEST_CASE("robots end a spin in about the time that their motors need", "[unit]") {
  for (const char* name : {"firasim", "vsss"}) {
    const RobotModel robot = loadRobot(name)->robot, limits = steady(robot);
    constexpr int kSteps = 4;
    const double dt = 1.0 / 60.0;
    Drive drive(robot, dt / kSteps, 0.0);
    BodyMotion motion;
    motion.yaw = 30.0;
    int ticks = 0;
    for (; ticks < 120 && motion.yaw > 1.0; ++ticks) {
      const Twist command = limitTwist(limits, {motion.forward, motion.yaw}, {}, dt);
      drive.setCommand(inverseKinematics(robot, command));
      for (int step = 0; step < kSteps; ++step) {
        const BodyMotion change = drive.step(motion);
        motion.forward += change.forward;
        motion.yaw += change.yaw;
      }
    }
    CAPTURE(name, ticks, motion.yaw);
    CHECK(ticks * dt < 1.25 * 30.0 / limits.turnAcceleration());
  }
}

TEST_CASE("twists of teams turn as hard as the motors pull straight ahead", "[unit]") {
  const RobotModel robot = loadRobot("firasim")->robot;
  CHECK(steady(robot).turnAcceleration() == Approx(robot.motorPull() / (robot.axle_track / 2)));
  CHECK(steady(robot).turnAcceleration() < robot.turnAcceleration());
}

TEST_CASE("the straight reference reaches an empty field's goal in about the bound", "[unit]") {
  auto pilot = makePilot(*parseNavigator("straight"));
  REQUIRE(pilot);
  const RobotModel robot = test::paperRobot(1.0);
  NavigationGoal goal;
  goal.position = {0.6, 0.0};
  const auto result = test::kinematicTrial(**pilot, robot, {}, {{-0.6, 0.0}, 0.0}, goal, {});
  CHECK(result.reached);
  CHECK(result.time == Approx(1.17 / 1.0 + 1.0 / 10.0).epsilon(0.03));
}

}  // namespace fulbito
