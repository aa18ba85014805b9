#include "engine/core/models/spin_ratio.hpp"

#include <cmath>

#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("the measured spin ratio holds at its points, between and outside", "[unit]") {
  RobotModel robot;
  CHECK(SpinRatio(robot).at(0.7) == 1.0);
  robot.spin_slow_speed = 0.4;
  robot.spin_slow_ratio = 0.9;
  robot.spin_fast_speed = 0.8;
  robot.spin_fast_ratio = 1.1;
  const SpinRatio ratio(robot);
  CHECK(ratio.at(0.0) == Approx(0.9));
  CHECK(ratio.at(0.4) == Approx(0.9));
  CHECK(ratio.at(0.6) == Approx(1.0));
  CHECK(ratio.at(0.8) == Approx(1.1));
  CHECK(ratio.at(2.0) == Approx(1.1));
}

TEST_CASE("the command for a spin makes that spin, and a robot that drives turns as ideal wheels", "[unit]") {
  for (const char* name : {"firasim", "vsss", "jung-lee-2015"}) {
    const RobotModel robot = loadRobot(name)->robot;
    const SpinRatio ratio(robot);
    for (const double spin : {-40.0, -15.0, -3.0, 0.0, 2.0, 11.0, 14.0, 18.0, 30.0, 60.0}) {
      CAPTURE(name, spin);
      const double command = ratio.commandFor({0.0, spin});
      const double turned = command * ratio.at(std::abs(command) * robot.axle_track / 2);
      CHECK(turned == Approx(spin).epsilon(0.005));
      CHECK(ratio.commandFor({100.0, spin}) == Approx(spin).epsilon(1e-12));
    }
  }
}

TEST_CASE("a command that slows a spin lets the inner edges of the wheels roll", "[unit]") {
  for (const char* name : {"firasim", "vsss", "jung-lee-2015"}) {
    const RobotModel robot = loadRobot(name)->robot;
    const SpinRatio ratio(robot);
    const double play = robot.wheel_width / robot.axle_track;
    for (const double spin : {-40.0, -11.0, 2.0, 14.0, 30.0}) {
      CAPTURE(name, spin);
      const double command = ratio.slowingCommandFor({0.0, spin});
      const double outer = ratio.isOne() ? 1.0 : 1.0 + play;
      const double rims = command * ratio.at(std::abs(command) * robot.axle_track / 2) * outer;
      CHECK(rims == Approx(spin * (1.0 - play)).epsilon(0.005));
    }
  }
}

}  // namespace fulbito
