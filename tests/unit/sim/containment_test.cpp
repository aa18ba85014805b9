#include <cmath>
#include <vector>

#include "engine/core/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

// A body of inscribed radius r that touches a goal post may come this near to both walls of the corner.
bool allInside(const World& world) {
  const FieldGeometry& field = world.config().field;
  for (const RobotState& robot : world.state().robots) {
    if (!insideField(field, robot.pose.position, 0.0375 / std::sqrt(2.0) - 0.001)) return false;
  }
  for (const BallState& ball : world.state().balls) {
    if (!insideField(field, ball.position, 0.0215 / std::sqrt(2.0) - 0.001)) return false;
  }
  return true;
}

// The ball's centre as the robot sees it.
Vec2 seenFromRobot(const World& world) {
  const Pose2& pose = world.state().robots[0].pose;
  const Vec2 ahead = math::unit(pose.heading), to = world.state().balls[0].position - pose.position;
  return {dot(ahead, to), cross(ahead, to)};
}

// Whether a ball shot at `speed` at a resting robot goes through it: from behind its centre to before it in
// one physics step, between its sides.
bool passesRobot(const PhysicsProfile& physics, double speed, double start, double aside) {
  WorldConfig config{wideField(), readEachStep(physics), {}, {}, {}};
  config.robots.push_back({vsssPreset().robot, {}, {}, 0.0});
  config.balls.push_back({vsssPreset().ball, {start, aside}, {speed, 0.0}, {speed, 0.0}});
  World world = makeWorld(config);
  Vec2 before = seenFromRobot(world);
  for (int step = 0; step < config.physics.control_rate / 6; ++step) {
    run(world, {}, 1);
    const Vec2 now = seenFromRobot(world);
    const bool between_sides = std::abs(now.y) < 0.0375 && std::abs(before.y) < 0.0375;
    if (between_sides && before.x < 0.0 && now.x > 0.0) return true;
    before = now;
  }
  return false;
}

}  // namespace

TEST_CASE("no ball passes through a robot up to the profile's ball speed", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  int passed = 0;
  for (int step = 1; step <= 10; ++step) {
    const double speed = physics.max_ball_speed * step / 10;
    for (int i = 0; i < 50; ++i) {
      // Different distances meet the robot at different places within a step's travel.
      if (passesRobot(physics, speed, -0.12 - 0.0031 * i, 0.001 * (i % 21 - 10))) ++passed;
    }
  }
  CHECK(passed == 0);
}

TEST_CASE("no ball passes through a wall up to the profile's ball speed", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  Rng rng(7, Stream::kTest);
  for (int i = 0; i < 300; ++i) {
    const Vec2 velocity = math::unit(rng.uniform(-math::kPi, math::kPi)) * physics.max_ball_speed;
    WorldConfig config{{}, physics, {}, {}, {}};
    config.balls.push_back(
        {vsssPreset().ball, {rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)}, velocity, velocity});
    World world = makeWorld(config);
    for (int tick = 0; tick < 30; ++tick) {
      run(world, {}, 1);
      if (!allInside(world)) FAIL("shot " << i << " is outside at tick " << tick);
    }
  }
}

TEST_CASE("a million ticks of random driving leave everything inside the walls", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics());
  CAPTURE(physics.name);
  World world = makeWorld(matchConfig(vsssPreset(), physics, 3, {}));
  Rng rng(1, Stream::kWheelCommands);
  std::vector<WheelSpeeds> commands(6);
  int outside = 0;
  for (int tick = 0; tick < 500'000; ++tick) {
    // One robot in each tick changes its mind, so that each holds its wheels long enough to go somewhere.
    WheelSpeeds& wheels = commands[rng.below(6)];
    wheels = {rng.uniform(-46.0, 46.0), rng.uniform(-46.0, 46.0)};
    if (tick % 10'000 == 0) world = makeWorld(matchConfig(vsssPreset(), physics, 3, {}));
    world.step(commands);
    if (!allInside(world)) ++outside;
  }
  CHECK(outside == 0);
}

TEST_CASE("robots that all push the ball into walls and corners leave nothing outside", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  World world = makeWorld(matchConfig(vsssPreset(), physics, 3, {}));
  std::vector<WheelSpeeds> commands(6);
  int outside = 0;
  for (int tick = 0; tick < 30'000; ++tick) {
    const WorldState& state = world.state();
    for (std::size_t i = 0; i < 6; ++i) commands[i] = chase(state.robots[i], state.balls[0].position);
    world.step(commands);
    if (!allInside(world)) ++outside;
  }
  CHECK(outside == 0);
}
