#include "strategies/libero_approach.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/strategies/libero_scenes.hpp"

namespace fulbito {

TEST_CASE("libero comes round a lying ball without sliding past it", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    CHECK(test::scoresAlone({0.533, 0.425}, {{-0.508, -0.193}, -2.98}, side) < 2.4);
    CHECK(test::scoresAlone({0.532, 0.488}, {{-0.611, -0.241}, 0.09}, side) < 2.4);
  }
}

TEST_CASE("libero overtakes a rolling ball whose direction it has to mend", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  for (const double side : {1.0, -1.0}) {
    RobotState robot;
    robot.pose = {{-0.095, side * 0.01}, side * -0.2};
    robot.velocity = {0.72, 0.0};
    int hand = 0;
    const Twist twist = libero::driveThrough(pitch, robot, {}, {1.0, 0.0}, 0.09, {0.72, 0.0}, hand);
    CHECK(twist.linear > 1.1);
  }
}

}  // namespace fulbito
