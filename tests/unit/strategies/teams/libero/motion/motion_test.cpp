#include "strategies/teams/libero/motion/motion.hpp"

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"
#include "strategies/skills/quick_twist.hpp"
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

/// The ticks until a robot that stands has driven through a place half a metre away, `bearing` [rad] off its
/// heading, in a world; 0 if it misses the place by more than 2 cm.
template <typename Drive>
int ticksThrough(const MatchInfo& info, double bearing, const Drive& drive) {
  const Vec2 from{-0.3, 0.0}, way = math::unit(bearing) * 0.5;
  WorldConfig config;
  config.field = info.field;
  config.physics = info.physics;
  config.robots.push_back({info.robot, {from, 0.0}, {}, 0.0});
  auto world = World::create(config);
  REQUIRE(world);
  for (int tick = 0; tick < 150; ++tick) {
    const RobotState& robot = world->state().robots.front();
    const Vec2 driven = intoFrame(way / norm(way), robot.pose.position - from);
    if (driven.x >= norm(way)) return std::abs(driven.y) < 0.02 ? tick : 0;
    const WheelSpeeds wheels =
        quickTwist(info.robot, robot, drive(robot, from + way), info.physics.controlPeriod()).wheels;
    world->step({&wheels, 1});
  }
  return 0;
}

}  // namespace

TEST_CASE("a robot that speeds up slowly turns over its way, and is there sooner", "[unit]") {
  const MatchInfo info = test::infoOf(3, "firasim");
  const libero::Pitch pitch(info);
  for (const double bearing : {0.4, 0.8, 1.2, -0.4, -0.8, -1.2}) {
    const int ticks = ticksThrough(info, bearing, [&](const RobotState& robot, Vec2 place) {
      return libero::passThrough(pitch, robot, place);
    });
    const int steered = ticksThrough(info, bearing, [&](const RobotState& robot, Vec2 place) {
      return libero::alongHeading(pitch, robot, math::angleOf(place - robot.pose.position), pitch.speed);
    });
    CAPTURE(bearing, ticks, steered);
    CHECK(ticks > 0);
    CHECK(ticks + 2 <= steered);
  }
}

TEST_CASE("a turn is quickest near its place, and where robots speed up fast", "[unit]") {
  for (const char* model : {"vsss", "firasim"}) {
    const libero::Pitch pitch(test::infoOf(3, model));
    RobotState robot;
    double last = pitch.tuning.turn_gain;
    CHECK(libero::turnGain(pitch, robot, 0.0) == last);
    for (double way = 0.05; way < 1.5; way += 0.05) {
      const double gain = libero::turnGain(pitch, robot, way);
      CHECK(gain <= last);
      if (pitch.shoves) CHECK(gain == pitch.tuning.turn_gain);
      last = gain;
    }
    robot.velocity = {1.0, 0.0};
    CHECK(libero::turnGain(pitch, robot, 0.5) >= libero::turnGain(pitch, RobotState{}, 0.5));
  }
}

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
