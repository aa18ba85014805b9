#include "strategies/teams/libero/motion/motion.hpp"

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/driven.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

RobotState anyRobot(Rng& rng) {
  RobotState robot;
  robot.pose = {{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)}, rng.uniform(-math::kPi, math::kPi)};
  return robot;
}

}  // namespace

TEST_CASE("libero's robots come to rest where they should, an end along the heading", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  Rng rng(1, test::kTestStream);
  for (int run = 0; run < 200; ++run) {
    RobotState robot = anyRobot(rng);
    const Vec2 place{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)};
    const double heading = rng.uniform(-math::kPi, math::kPi);
    for (int tick = 0; tick < 240; ++tick) {
      robot = test::driven(info, robot, libero::restAt(pitch, robot, place, heading, pitch.ball_radius));
    }
    CAPTURE(run);
    CHECK(distance(robot.pose.position, place) < 0.02);
    CHECK(norm(robot.velocity) < 0.02);
    CHECK(std::abs(libero::foldedError(heading, robot.pose.heading)) < 0.05);
  }
}

TEST_CASE("libero's robots turn the shorter way, with either end ahead", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  Rng rng(2, test::kTestStream);
  for (int i = 0; i < 1000; ++i) {
    const RobotState robot = anyRobot(rng);
    const double heading = rng.uniform(-math::kPi, math::kPi);
    const Twist twist = libero::alongHeading(pitch, robot, heading, 1.0);
    const double error = libero::foldedError(heading, robot.pose.heading);
    CHECK(std::abs(error) <= math::kPi / 2);
    CHECK(twist.angular * error >= 0.0);
    CHECK(std::abs(twist.linear) <= 1.0);
    // The leading end is the one that points along the heading.
    CHECK(twist.linear * dot(math::unit(heading), math::unit(robot.pose.heading)) >= 0.0);
  }
}

}  // namespace fulbito
