#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr BodyId kWall{BodyKind::kWall, 0};
constexpr BodyId robotId(std::uint16_t i) { return {BodyKind::kRobot, i}; }
constexpr BodyId ballId(std::uint16_t i) { return {BodyKind::kBall, i}; }
constexpr BodyId obstacleId(std::uint16_t i) { return {BodyKind::kObstacle, i}; }

// Runs until something touches. @return the events of that tick
std::vector<ContactEvent> firstContact(World& world, WheelSpeeds wheels) {
  for (int tick = 0; tick < 600; ++tick) {
    run(world, wheels, 1);
    if (!world.contacts().empty()) return {world.contacts().begin(), world.contacts().end()};
  }
  return {};
}

}  // namespace

TEST_CASE("a ball's impact on a wall is one event with the momentum that changed hands", "[unit]") {
  WorldConfig config = loneBall(vsssPreset().ball, standardPhysics(), {1.5, 0.0}, {1.5, 0.0});
  config.balls[0].position = {7.95, 0.25};
  World world = makeWorld(config);
  const auto events = firstContact(world, {});
  REQUIRE(events.size() == 1);
  CHECK(events[0].a == kWall);
  CHECK(events[0].b == ballId(0));
  CHECK(events[0].began);
  CHECK(events[0].point.x == Approx(8.0).margin(0.002));
  CHECK(events[0].point.y == Approx(0.25).margin(0.001));
  CHECK(events[0].normal.x == Approx(-1.0));
  CHECK(events[0].normal.y == Approx(0.0).margin(1e-6));
  CHECK(events[0].impulse == Approx(config.balls[0].model.mass * 1.5 * 1.5).epsilon(0.01));
}

TEST_CASE("a robot that drives into a fixed obstacle and keeps pushing begins to touch it once", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.robots[0].velocity = {0.52, 0.0};
  config.obstacles = {discAt({2.0, 0.0}), discAt({0.2, 0.0})};
  World world = makeWorld(config);
  const auto events = firstContact(world, {20.0, 20.0});
  REQUIRE(events.size() == 1);
  CHECK(events[0].a == robotId(0));
  CHECK(events[0].b == obstacleId(1));
  CHECK(events[0].began);
  CHECK(events[0].normal.x == Approx(1.0));
  CHECK(events[0].point.x == Approx(0.2 - 0.0335).margin(0.0015));
  // The impact stops the robot, which bounces with its restitution, and its motor keeps pulling.
  const double least = 0.15 * 0.52, most = 0.15 * (0.52 * 1.1 + 9.0 / 60);
  CHECK(events[0].impulse >= least);
  CHECK(events[0].impulse <= most);

  int touching = 0, begins = 0;
  run(world, {20.0, 20.0}, 30);  // the bounce is over
  for (int tick = 0; tick < 60; ++tick) {
    run(world, {20.0, 20.0}, 1);
    for (const ContactEvent& event : world.contacts()) ++touching, begins += event.began ? 1 : 0;
  }
  CHECK(touching == 60);
  CHECK(begins == 0);
}

TEST_CASE("a robot pressed against something gives the motor's force times the tick as impulse", "[unit]") {
  const RobotModel robot = vsssPreset().robot;
  WorldConfig config = loneRobot(robot, standardPhysics());
  config.obstacles = {discAt({0.2, 0.0})};
  World world = makeWorld(config);
  run(world, {40.0, 40.0}, 120);
  REQUIRE(world.contacts().size() == 1);
  CHECK(world.contacts()[0].impulse == Approx(robot.mass * robot.wheel_acceleration / 60).epsilon(0.02));
}

TEST_CASE("a robot that hits a ball is the first of the two", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.robots[0].velocity = {0.78, 0.0};
  config.balls.push_back({vsssPreset().ball, {0.1, 0.0}, {}, {}});
  World world = makeWorld(config);
  const auto events = firstContact(world, {30.0, 30.0});
  REQUIRE(events.size() == 1);
  CHECK(events[0].a == robotId(0));
  CHECK(events[0].b == ballId(0));
  CHECK(events[0].normal.x == Approx(1.0));
  CHECK(events[0].impulse >= 0.056 * 0.55);
  CHECK(events[0].impulse <= 0.056 * 0.64);
}

TEST_CASE("a robot that stands near something without touching gives no event", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.obstacles = {discAt({0.0375 + 0.0335 + 0.0003, 0.0})};
  World world = makeWorld(config);
  for (int tick = 0; tick < 120; ++tick) {
    run(world, {}, 1);
    CHECK(world.contacts().empty());
  }
}

TEST_CASE("bodies that touch from the beginning act on each other in the first step", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.physics.substeps = 1;
  const double gap = 0.0002, speed = 0.02;  // so slow that the step is neither split nor searched
  const BallModel ball = vsssPreset().ball;
  config.balls.push_back({ball, {0.0375 + ball.radius + gap, 0.0}, {-speed, 0.0}, {-speed, 0.0}});
  World world = makeWorld(config);
  run(world, {}, 1);
  CHECK(world.contacts().size() == 1);
  CHECK(std::abs(world.state().balls[0].velocity.x) < speed / 2);
}

TEST_CASE("events come in the order of their bodies, each pair once, with unit normals", "[unit]") {
  WorldConfig config = matchConfig(vsssPreset(), standardPhysics(), 5, largeField());
  for (double y : {-0.5, 0.5}) config.obstacles.push_back(discAt({0.0, y}, ObstacleMotion::kPushable));
  World world = makeWorld(config);
  const auto key = [](const ContactEvent& e) {
    return std::array{static_cast<int>(e.a.kind), int{e.a.index}, static_cast<int>(e.b.kind), int{e.b.index}};
  };
  std::vector<WheelSpeeds> commands(10);
  std::size_t most = 0;
  for (int tick = 0; tick < 1200; ++tick) {
    for (std::size_t i = 0; i < 10; ++i)
      commands[i] = chase(world.state().robots[i], world.state().balls[0].position);
    world.step(commands);
    const auto events = world.contacts();
    most = std::max(most, events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (i > 0 && !(key(events[i - 1]) < key(events[i]))) FAIL("out of order at tick " << tick);
      if (!(key(events[i])[0] < key(events[i])[2] ||
            (events[i].a.kind == events[i].b.kind && events[i].a.index < events[i].b.index)))
        FAIL("bodies swapped at tick " << tick);
      if (std::abs(norm(events[i].normal) - 1.0) > 1e-5 || !(events[i].impulse > 0.0))
        FAIL("bad event at tick " << tick);
    }
  }
  CHECK(most >= 10);
}

namespace {

/// [m] from a point to the outline of a square of 75 mm around the origin; 0 inside.
double toSquare(Vec2 p, double heading) {
  const Vec2 ahead = math::unit(heading);
  const Vec2 outside{std::max(std::abs(dot(ahead, p)) - 0.0375, 0.0),
                     std::max(std::abs(cross(ahead, p)) - 0.0375, 0.0)};
  return norm(outside);
}

}  // namespace

TEST_CASE("a ball that touches a robot and is past it within the tick is seen", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  Rng rng(2071, Stream::kWheelCommands);
  int touched = 0, passed_in_tick = 0;
  for (int shot = 0; shot < 250; ++shot) {
    const double heading = rng.uniform(-math::kPi, math::kPi), speed = rng.uniform(5.0, 10.0);
    const Vec2 along = math::unit(rng.uniform(-math::kPi, math::kPi));
    // Passes the robot's corners and edges on either side, by a few millimetres.
    const double behind = rng.uniform(0.075, 0.2), aside = rng.uniform(-0.08, 0.08);
    const Vec2 start = along * -behind + perp(along) * aside;
    double nearest = 1.0;
    for (double way = 0.0; way < 0.4; way += 0.0002)
      nearest = std::min(nearest, toSquare(start + along * way, heading));
    if (toSquare(start, heading) < 0.025 || std::abs(nearest - preset.ball.radius) < 0.0015) continue;
    WorldConfig config = loneRobot(preset.robot, physics);
    config.robots[0].pose.heading = heading;
    config.balls.push_back({preset.ball, start, along * speed, along * speed});
    World world = makeWorld(config);
    bool seen = false;
    for (int tick = 0; tick < 6 && !seen; ++tick) {
      const Vec2 before = world.state().balls[0].position;
      run(world, {}, 1);
      seen = !world.contacts().empty();
      const bool was_away = toSquare(before, heading) > 0.03,
                 is_away = toSquare(world.state().balls[0].position, heading) > 0.03;
      if (seen && was_away && is_away) ++passed_in_tick;
    }
    CAPTURE(shot, nearest, speed);
    CHECK(seen == (nearest < preset.ball.radius));
    touched += seen ? 1 : 0;
  }
  CHECK(touched > 50);
  if (physics.controlPeriod() > 0.015) CHECK(passed_in_tick > 10);
}
