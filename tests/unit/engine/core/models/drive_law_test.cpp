#include "engine/core/models/drive_law.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kWidening = 1.319, kRise = 2.410;  // [s], [s^2/m]

RobotModel slippingRobot() {
  RobotModel robot;
  robot.axle_track = 0.4;
  robot.curve_widening = kWidening;
  robot.curve_widening_rise = kRise;
  return robot;
}

/// The rims of a robot with a track of 0.4 m that drives at `v` in a curve of radius `r` to the left.
RimSpeeds curve(double v, double r) { return {v * (1 - 0.2 / r), v * (1 + 0.2 / r)}; }

double radius(RimSpeeds rims) { return 0.2 * (rims.right + rims.left) / (rims.right - rims.left); }

double speed(RimSpeeds rims) { return (rims.left + rims.right) / 2; }

/// A robot of 8 cm track whose wheels are 6 mm wide.
RobotModel wideWheels(double drag) {
  RobotModel robot;
  robot.axle_track = 0.08;
  robot.wheel_width = 0.006;
  robot.wheel_acceleration = 2.0;
  robot.rolling_drag = drag;
  robot.wheel_braking = 2.0 + 2.0 * drag;
  robot.longitudinal_grip = 6.0;
  return robot;
}

RimSpeeds settled(const RobotModel& robot, RimSpeeds rims, RimSpeeds target) {
  const DriveLaw law(robot, 0.01);
  const RimSpeeds limits{law.limit(), law.limit()};
  for (int i = 0; i < 500; ++i) {
    const RimSpeeds change = law.change(rims, law.pulls(rims, target, limits));
    rims = {rims.left + change.left, rims.right + change.right};
  }
  return rims;
}

double yawRate(RimSpeeds rims) { return (rims.right - rims.left) / 0.08; }

/// Whether a wheel of `rim` [m/s] after the step reaches what its motor seeks, or its motor is at its limit.
bool isBalanced(double rim, double target, double play, double pull, double limit) {
  constexpr double kClose = 2e-6;  // [m/s]
  const double lack = std::clamp(rim, target - play, target + play) - rim;
  if (lack > kClose) return pull >= limit - kClose;
  if (lack < -kClose) return pull <= -limit + kClose;
  // A wheel that pulls rolls on one of its edges.
  return std::abs(pull) < kClose || std::abs(rim - target + std::copysign(play, pull)) < kClose;
}

}  // namespace

TEST_CASE("a robot that pushes through a curve loses half of its wheels' width times the yaw rate",
          "[unit]") {
  for (const double sense : {1.0, -1.0}) {
    const RimSpeeds target{0.3 * sense, 0.5 * sense};
    const RimSpeeds reached = settled(wideWheels(1.5), {}, target);
    CHECK(yawRate(reached) == Approx(sense * 0.2 / 0.08));
    CHECK(speed(reached) == Approx(sense * (0.4 - 0.003 * 0.2 / 0.08)));
    // Narrow wheels lose nothing.
    RobotModel narrow = wideWheels(1.5);
    narrow.wheel_width = 0.0;
    CHECK(speed(settled(narrow, {}, target)) == Approx(0.4 * sense));
  }
}

TEST_CASE("a spin comes to roll on the outer edges from below and stays between the edges from above",
          "[unit]") {
  const RimSpeeds target{-0.4, 0.4};
  CHECK(yawRate(settled(wideWheels(0.0), {}, target)) == Approx(0.4 / 0.043));
  RobotModel slippery = wideWheels(0.0);
  slippery.longitudinal_grip = 2.0;  // as little as the motors use: nothing is left for scrubbing
  const double rate = yawRate(settled(slippery, {-0.6, 0.6}, target));
  CHECK(rate <= 0.4 / 0.037 + 1e-9);
  CHECK(rate >= 0.4 / 0.043 - 1e-9);
}

TEST_CASE("what the motors leave of the grip brakes a turn", "[unit]") {
  // Both wheels push with all their force, 3.5 of 6 m/s2 each: the edges scrub with the rest.
  const RobotModel robot = wideWheels(1.5);
  const DriveLaw law(robot, 0.01);
  const RimSpeeds rims{-0.2, 0.2}, limits{law.limit(), law.limit()};
  const RimSpeeds pulls = law.pulls(rims, {5.0, 5.0}, limits);
  CHECK(pulls.left == Approx(3.5 * 0.01));
  const RimSpeeds change = law.change(rims, pulls);
  const double couple = robot.mass / 2 * (2 * 6.0 - 2 * 3.5) * 0.003;  // [N m]
  CHECK(yawRate(change) == Approx(-couple / robot.inertia() * 0.01));
  CHECK(speed(change) == Approx(2.0 * 0.01));
}

TEST_CASE("scrubbing edges stop a turn but do not reverse it", "[unit]") {
  const DriveLaw law(wideWheels(0.0), 0.01);
  const RimSpeeds change = law.change({-1e-5, 1e-5}, {});
  CHECK(change.left == Approx(1e-5));
  CHECK(change.right == Approx(-1e-5));
}

TEST_CASE("both motors pull until an edge of their wheel rolls, or as much as they can", "[unit]") {
  std::mt19937_64 random(31);
  const auto draw = [&random](double most) {
    return most * (2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0);
  };
  int states = 0, unbalanced = 0;
  for (const double drag : {0.0, 1.5, 3.0}) {
    const DriveLaw law(wideWheels(drag), 0.01);
    const RimSpeeds limits{law.limit(), 0.7 * law.limit()};
    for (int i = 0; i < 3000; ++i, ++states) {
      const double near = i % 3 == 0 ? 0.02 : i % 3 == 1 ? 0.1 : 1.0, common = draw(near), turn = draw(near);
      const RimSpeeds rims{common - turn, common + turn};
      const RimSpeeds target{rims.left + draw(near), rims.right + draw(near)};
      const RimSpeeds pulls = law.pulls(rims, target, limits), change = law.change(rims, pulls);
      const double play = 0.006 / 0.08 * std::abs(turn);
      const bool left = isBalanced(rims.left + change.left, target.left, play, pulls.left, limits.left);
      const bool right = isBalanced(rims.right + change.right, target.right, play, pulls.right, limits.right);
      unbalanced += left && right ? 0 : 1;
      // A mirrored motion has mirrored pulls, to the last bit.
      const RimSpeeds back =
          law.pulls({rims.right, rims.left}, {target.right, target.left}, {limits.right, limits.left});
      CAPTURE(drag, rims.left, rims.right, target.left, target.right);
      REQUIRE(back.left == pulls.right);
      REQUIRE(back.right == pulls.left);
    }
  }
  CHECK(unbalanced * 1000 <= states);  // states near rest may need more rounds than the limit
}

TEST_CASE("a curve widens by the same length for every radius, and more at speed", "[unit]") {
  const DriveLaw law(slippingRobot(), 0.01);
  for (const double v : {0.1, 0.3, 0.5}) {
    for (const double r : {-3.75, -1.875, 0.3, 1.875, 3.75}) {
      const RimSpeeds reached = law.reached(curve(v, r));
      CHECK(radius(reached) == Approx(r + std::copysign(kWidening * v + kRise * v * v, r)));
      CHECK(speed(reached) == Approx(v));
    }
  }
}

TEST_CASE("a curve driven backward widens as much", "[unit]") {
  const DriveLaw law(slippingRobot(), 0.01);
  const RimSpeeds reached = law.reached(curve(-0.3, 2.0));
  CHECK(radius(reached) == Approx(2.0 + kWidening * 0.3 + kRise * 0.09));
  CHECK(speed(reached) == Approx(-0.3));
}

TEST_CASE("slip leaves lines and spins in place alone, and sets in without a jump between", "[unit]") {
  const DriveLaw law(slippingRobot(), 0.01);
  CHECK(law.reached({0.4, 0.4}).right == 0.4);
  CHECK(law.reached({-0.3, 0.3}).right == Approx(0.3));
  const RimSpeeds below = law.reached({1e-9, 0.4}), above = law.reached({-1e-9, 0.4});
  CHECK(below.right == Approx(above.right));
  CHECK(below.right - below.left < 0.39);
  for (double left = -0.4; left < 0.399; left += 0.01) {  // ever wider curves turn ever less
    const RimSpeeds tight = law.reached({left, 0.4}), wide = law.reached({left + 0.01, 0.4});
    CHECK(tight.right - tight.left > wide.right - wide.left);
  }
}

TEST_CASE("the command for a motion leads to that motion", "[unit]") {
  const DriveLaw law(slippingRobot(), 0.01);
  for (double left = -0.6; left <= 0.6; left += 0.05) {
    for (double right = -0.6; right <= 0.6; right += 0.05) {
      const RimSpeeds back = law.reached(law.commandFor({left, right}));
      CHECK(back.left == Approx(left).margin(1e-12));
      CHECK(back.right == Approx(right).margin(1e-12));
    }
  }
}

TEST_CASE("a robot without widening reaches its commands to the bit", "[unit]") {
  const DriveLaw law(RobotModel{}, 0.01);
  const RimSpeeds command{0.123456789, -0.987654321};
  CHECK(law.reached(command).left == command.left);
  CHECK(law.reached(command).right == command.right);
  CHECK(law.commandFor(command).left == command.left);
  CHECK(law.commandFor(command).right == command.right);
}

TEST_CASE("a robot that is rolled forward drives the wider curve", "[unit]") {
  RobotModel robot = slippingRobot();
  robot.wheel_radius = 0.105, robot.max_wheel_speed = 8.0, robot.length = 0.66, robot.width = 0.43;
  const RimSpeeds rims = curve(0.3, 1.875);
  const WheelSpeeds command{rims.left / 0.105, rims.right / 0.105};
  RobotState state;
  for (int i = 0; i < 600; ++i) state = rolledForward(robot, state, command, 1.0 / 60);
  CHECK(0.3 / state.angular_velocity == Approx(1.875 + kWidening * 0.3 + kRise * 0.09));
}

}  // namespace fulbito
