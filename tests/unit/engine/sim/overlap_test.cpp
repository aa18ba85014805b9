// Bodies do not overlap deeply, however they are driven. tests/soak/contact_depths has the depths in matches.
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kBallDepth = 0.002;   // [m]
constexpr double kRobotDepth = 0.005;  // [m]

Depths depthsOf(World& world, int ticks, const auto& command) {
  Depths depths;
  const WorldConfig& config = world.config();
  std::vector<WheelSpeeds> commands(config.robots.size());
  for (int tick = 0; tick < ticks; ++tick) {
    for (std::size_t i = 0; i < commands.size(); ++i) commands[i] = command(world.state(), i, tick);
    world.step(commands);
    depths.look(config.robots[0].model, config.balls[0].model.radius, world.state());
  }
  return depths;
}

// A robot at full speed 0.3 m before a wall, with the ball in front of it and others close behind.
WorldConfig trainAtWall(const RobotPreset& preset, const PhysicsProfile& physics, int robots, double speed,
                        double shift, double gap = 0.0015) {
  WorldConfig config{{}, physics, {}, {}, {}};
  const double front = 0.45 - shift, pitch = preset.robot.length + gap;
  for (int i = 0; i < robots; ++i) {
    config.robots.push_back({preset.robot, {{front - pitch * i, 0.4}, 0.0}, {speed, 0.0}, 0.0});
  }
  config.balls.push_back({preset.ball, {front + 0.0375 + 0.0217, 0.4}, {speed, 0.0}, {speed, 0.0}});
  return config;
}

}  // namespace

TEST_CASE("robots that all push the ball come into nobody", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  World world = makeWorld(matchConfig(preset, physics, 3, {}));
  Rng rng(11, kTestStream);
  const Depths depths = depthsOf(world, 6'000, [&](const WorldState& state, std::size_t i, int tick) {
    // Drives away from the ball now and then: otherwise the crowd stays in a corner.
    if (tick % 300 > 240) return chase(state.robots[i], {rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)});
    return chase(state.robots[i], state.balls[0].position);
  });
  CHECK(depths.ball <= kBallDepth);
  CHECK(depths.ball > 0.0);  // they did touch
  if (physics.name != "fast") CHECK(depths.robot <= kRobotDepth);
}

TEST_CASE("robots that carry the ball into a wall stop there, with the ball before them", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  const int robots = GENERATE(1, 2, 3);
  CAPTURE(physics.name, preset.robot.name, robots);
  for (const double speed : {0.4, 0.8, 1.19}) {
    const double wheels = speed / preset.robot.wheel_radius;
    for (int phase = 0; phase < 8; ++phase) {
      World world = makeWorld(trainAtWall(preset, physics, robots, speed, 0.0013 * phase));
      double back = 0.0;
      const Depths depths = depthsOf(world, 90, [&](const WorldState& state, std::size_t, int) {
        if (std::abs(state.robots[0].pose.heading) < 0.5) back = std::max(back, -state.robots[0].velocity.x);
        return WheelSpeeds{wheels, wheels};
      });
      CAPTURE(speed, phase);
      CHECK(depths.ball <= kBallDepth);
      if (physics.name != "fast") CHECK(depths.robot <= kRobotDepth);
      CHECK(back <= 0.15);
    }
  }
}

TEST_CASE("a row of robots stops with the robot that the ball between them stops", "[unit]") {
  const auto physics = GENERATE(standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  const double speed = GENERATE(0.6, 0.9, 1.15);
  const double wheels = speed / preset.robot.wheel_radius;
  for (const double gap : {0.0006, 0.001, 0.002}) {  // the engine treats robots within 0.5 mm as touching
    for (int phase = 0; phase < 8; ++phase) {
      WorldConfig config = trainAtWall(preset, physics, 3, speed, 0.0013 * phase, gap);
      const Vec2 ahead{config.balls[0].position.x + preset.ball.radius + 0.0005 + preset.robot.length / 2,
                       0.4};
      config.robots.push_back({preset.robot, {ahead, 0.0}, {speed, 0.0}, 0.0});
      World world = makeWorld(config);
      const Depths depths = depthsOf(
          world, 60, [&](const WorldState&, std::size_t, int) { return WheelSpeeds{wheels, wheels}; });
      CAPTURE(physics.name, preset.robot.name, speed, gap, phase);
      CHECK(depths.ball <= kBallDepth);
      CHECK(depths.robot <= kRobotDepth);
      CHECK(depths.robot > -gap);  // they did come closer
    }
  }
}

TEST_CASE("a row of robots stops with its first at the corner of one that turns", "[unit]") {
  const auto physics = GENERATE(standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  const double speed = GENERATE(0.6, 0.9, 1.15), yaw = GENERATE(-20.0, 20.0);
  const double wheels = speed / preset.robot.wheel_radius;
  const double turning = yaw * preset.robot.axle_track / 2 / preset.robot.wheel_radius;
  for (const double gap : {0.0006, 0.001, 0.003}) {
    for (int phase = 0; phase < 32; ++phase) {
      WorldConfig config = trainAtWall(preset, physics, 3, speed, 0.0013 * (phase % 8), gap);
      config.balls[0] = {preset.ball, {0.0, -0.4}, {}, {}};
      const Pose2 aside{{0.6, 0.43 + 0.015 * (phase / 8)}, 0.2 * (phase % 8)};
      config.robots.push_back({preset.robot, aside, {}, yaw});
      World world = makeWorld(config);
      const Depths depths = depthsOf(world, 30, [&](const WorldState&, std::size_t i, int) {
        return i == 3 ? WheelSpeeds{-turning, turning} : WheelSpeeds{wheels, wheels};
      });
      CAPTURE(physics.name, preset.robot.name, speed, yaw, gap, phase);
      CHECK(depths.robot <= kRobotDepth);
    }
  }
}

TEST_CASE("a robot that slides along the end wall passes the goal post", "[unit]") {
  // The end of the goal's side wall is in the face of the end wall there.
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  for (int phase = 0; phase < 20; ++phase) {
    CAPTURE(physics.name, phase);
    WorldConfig config{{}, physics, {}, {}, {}};
    config.robots.push_back(
        {vsssPreset().robot, {{-0.7122, 0.42 + 0.001 * phase}, -math::kPi / 2 - 0.02}, {0.0, -1.1}, 0.0});
    World world = makeWorld(config);
    double slowest = 1.1;
    for (int tick = 0; tick < 30 && world.state().robots[0].pose.position.y > 0.15; ++tick) {
      run(world, {44.0, 43.0}, 1);
      slowest = std::min(slowest, -world.state().robots[0].velocity.y);
    }
    CHECK(world.state().robots[0].pose.position.y < 0.15);
    CHECK(slowest > 0.9);
  }
}
TEST_CASE("robots that press a ball into a corner do not creep into each other", "[unit]") {
  const auto physics = GENERATE(standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  for (int turn = 0; turn < 6; ++turn) {
    WorldConfig config{{}, physics, {}, {}, {}};
    const double way = math::kPi / 4 + 0.08 * (turn - 2);  // toward the corner
    const Vec2 toward = math::unit(way), ball{0.66, 0.56};
    for (int i = 0; i < 5; ++i) {
      config.robots.push_back({preset.robot, {ball - toward * (0.07 + 0.085 * i), way}, {}, 0.0});
    }
    config.balls.push_back({preset.ball, ball, {}, {}});
    World world = makeWorld(config);
    const Depths depths = depthsOf(world, 300, [&](const WorldState& state, std::size_t i, int) {
      return chase(state.robots[i], state.balls[0].position);
    });
    CAPTURE(turn);
    CHECK(depths.ball <= kBallDepth);
    CHECK(depths.robot <= kRobotDepth);
    CHECK(depths.robot > 0.0);  // they did jam
  }
}

TEST_CASE("a robot that turns fast comes into nobody with its corners", "[unit]") {
  const auto physics = GENERATE(standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  const double top = preset.robot.max_wheel_speed;
  for (int phase = 0; phase < 8; ++phase) {
    WorldConfig config{{}, physics, {}, {}, {}};
    config.robots.push_back({preset.robot, {{0.0, 0.0}, 0.0}, {}, 0.0});
    config.robots.push_back({preset.robot, {{-0.3 - 0.003 * phase, 0.01 * phase - 0.035}, 0.0}, {}, 0.0});
    config.balls.push_back({preset.ball, {0.4, 0.4}, {}, {}});
    World world = makeWorld(config);
    const Depths depths = depthsOf(world, 240, [&](const WorldState& state, std::size_t i, int) {
      return i == 0 ? WheelSpeeds{-top, top} : chase(state.robots[1], state.robots[0].pose.position);
    });
    CAPTURE(phase);
    CHECK(depths.robot <= kRobotDepth);
    CHECK(depths.robot > -0.012);  // corners that meet between two ticks are apart at both
  }
}
