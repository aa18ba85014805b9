#include "strategies/prediction/time_to_reach.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {

TEST_CASE("the time along a line is the engine's", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const RobotPace pace(info.robot);
  for (const double start : {-0.8, -0.3, 0.0, 0.5, 1.1}) {
    WorldConfig config{info.field, info.physics, {}, {}, {}};
    config.robots.push_back({info.robot, {{-0.3, 0.0}, 0.0}, {start, 0.0}, 0.0});
    World world = std::move(*World::create(config));
    for (int tick = 1; tick < 60; ++tick) {
      const std::vector<WheelSpeeds> full{{info.robot.max_wheel_speed, info.robot.max_wheel_speed}};
      world.step(full);
      const double way = world.state().robots[0].pose.position.x + 0.3;
      if (way < 0.05 || way > 0.9) continue;
      CAPTURE(start, way);
      CHECK(timeAlong(pace, way, start) == Approx(tick * info.physics.controlPeriod()).margin(0.035));
    }
  }
}

TEST_CASE("the way from rest is the inverse of the time along it", "[unit]") {
  const RobotPace pace(test::matchInfo().robot);
  for (const double way : {0.0, 0.01, 0.1, 0.3, 1.0}) {
    CAPTURE(way);
    CHECK(wayFromRest(pace, timeAlong(pace, way, 0.0)) == Approx(way).margin(1e-6));
  }
}

TEST_CASE("no target beyond the farthest way is reached in time", "[unit]") {
  Rng rng(5, test::kTestStream);
  for (const char* name : {"vsss", "firasim"}) {
    const RobotPace pace((*loadRobot(name)).robot);
    for (int run = 0; run < 5000; ++run) {
      RobotState robot;
      robot.pose.heading = rng.uniform(-math::kPi, math::kPi);
      robot.velocity = test::drawVector(rng, 0.0, 1.2 * pace.speed);
      const Vec2 target = test::drawVector(rng, 0.0, run % 2 == 0 ? 0.01 : 1.5);
      CAPTURE(name, run);
      REQUIRE(norm(target) <= farthestIn(pace, norm(robot.velocity), timeToReach(pace, robot, target)));
    }
    // A robot at speed that faces its target drives that way.
    RobotState straight;
    straight.velocity.x = 0.5 * pace.speed;
    const double time = timeToReach(pace, straight, {0.8, 0.0});
    CHECK(farthestIn(pace, 0.5 * pace.speed, time) == Approx(0.8).margin(1e-5));
  }
}

TEST_CASE("the folded angle is within 0.004 rad", "[unit]") {
  for (double angle = 0.01; angle < math::kPi / 2; angle += 0.01) {
    CHECK(foldedAngle(std::sin(angle), std::cos(angle)) == Approx(angle).margin(0.004));
    CHECK(foldedAngle(-std::sin(angle), -std::cos(angle)) == Approx(angle).margin(0.004));
  }
}

TEST_CASE("either end leads, and farther takes longer", "[unit]") {
  const RobotPace pace(test::matchInfo().robot);
  Rng rng(2, test::kTestStream);
  for (int i = 0; i < 500; ++i) {
    RobotState robot;
    robot.pose = {{rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)}, rng.uniform(-math::kPi, math::kPi)};
    const Vec2 ahead = math::unit(rng.uniform(-math::kPi, math::kPi));
    const double away = rng.uniform(0.1, 0.8);
    const Vec2 target = robot.pose.position + ahead * away;
    RobotState turned = robot;
    turned.pose.heading = math::wrapAngle(robot.pose.heading + math::kPi);
    const double time = timeToReach(pace, robot, target);
    CHECK(timeToReach(pace, turned, target) == Approx(time).margin(1e-6));
    CHECK(timeToReach(pace, robot, target + ahead * 0.1) > time);
    CHECK(time >= timeAlong(pace, away, 0.0));
    robot.velocity = ahead * 0.5;
    CHECK(timeToReach(pace, robot, target) < time);
    robot.velocity = ahead * -0.5;
    CHECK(timeToReach(pace, robot, target) > time);
  }
}

}  // namespace fulbito
