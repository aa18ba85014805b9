#include <cmath>
#include <limits>

#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEST_CASE("wheel speeds and twists convert into each other", "[unit]") {
  RobotModel robot;
  robot.wheel_radius = 0.02, robot.axle_track = 0.08;
  const WheelSpeeds wheels = inverseKinematics(robot, {1.0, 5.0});
  CHECK(wheels.left == Approx(40.0));   // (1 - 5 * 0.04) / 0.02
  CHECK(wheels.right == Approx(60.0));  // (1 + 5 * 0.04) / 0.02
  const Twist twist = forwardKinematics(robot, wheels);
  CHECK(twist.linear == Approx(1.0));
  CHECK(twist.angular == Approx(5.0));
}

TEST_CASE("saturation clamps each wheel and stops on NaN", "[unit]") {
  const RobotModel robot;
  const WheelSpeeds wheels = saturate(robot, {kInfinity, kNaN});
  CHECK(wheels.left == robot.max_wheel_speed);
  CHECK(wheels.right == 0.0);
  CHECK(saturate(robot, {-1000.0, 3.0}).left == -robot.max_wheel_speed);
  CHECK(saturate(robot, {-1000.0, 3.0}).right == 3.0);
}

TEST_CASE("rounding goes to the nearest multiple and stays finite", "[unit]") {
  CHECK(roundedTo({1.004, -2.006}, 0.01).left == Approx(1.0));
  CHECK(roundedTo({1.004, -2.006}, 0.01).right == Approx(-2.01));
  CHECK(roundedTo({1.2345, 0.0}, 0.0).left == 1.2345);
  // A recording counts steps in integers, which have no negative zero.
  CHECK_FALSE(std::signbit(roundedTo({-0.001, -0.0}, 0.01).left));
  CHECK_FALSE(std::signbit(roundedTo({-0.001, -0.0}, 0.01).right));
  CHECK(roundedTo({1.7e308, -1.7e308}, 0.01).left == 1.7e308);
}

TEST_CASE("the default robot is valid and its circumradius is half its diagonal", "[unit]") {
  const RobotModel robot;
  CHECK(validate(robot));
  CHECK(robot.circumradius() == Approx(0.0530330).epsilon(1e-5));
  CHECK(robot.maxSpeed() == Approx(1.198).epsilon(1e-3));
}

TEST_CASE("validation names the key, the value and the allowed range", "[unit]") {
  RobotModel robot;
  robot.mass = -1;
  CHECK(validate(robot).error().message == "robot.mass = -1 is outside 0.001 ... 50 kg");
  CHECK(validate(robot).error().code == ErrorCode::kBadInput);
  robot.mass = kNaN;
  CHECK(validate(robot).error().message == "robot.mass = nan is outside 0.001 ... 50 kg");
  robot.mass = 0.15, robot.spin_slow_speed = 0.5, robot.spin_fast_speed = 0.5;
  CHECK(validate(robot).error().message == "robot.spin_fast_speed = 0.5 must be above spin_slow_speed = 0.5");
}

TEST_CASE("wheels that the body has no room for are refused", "[unit]") {
  RobotModel robot;
  robot.wheel_radius = 0.5;  // within the key's own range
  CHECK(validate(robot).error().message ==
        "robot.wheel_radius = 0.5 must be at most half of the body's longer side, 0.0375 m");
  robot.wheel_radius = 0.0375;
  CHECK(validate(robot));
  robot.axle_track = 0.1061;
  CHECK(validate(robot).error().message ==
        "robot.axle_track = 0.1061 must be at most the body's diagonal, 0.106066 m");
  robot.axle_track = 0.106;
  CHECK(validate(robot));
}

}  // namespace fulbito
