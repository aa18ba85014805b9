#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/shots.hpp"
#include "tests/support/test_stream.hpp"
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

}  // namespace

TEST_CASE("no ball passes through robots up to the profile's ball speed", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  const auto target = GENERATE(ShotTarget::kRobot, ShotTarget::kTwoRobots, ShotTarget::kRobotAtWall);
  CAPTURE(physics.name, preset.robot.name, static_cast<int>(target));
  Rng rng(5, kTestStream);
  int passed = 0;
  for (const double share : {0.4, 0.6, 0.8, 1.0}) {
    const double speed = share * physics.max_ball_speed;
    for (int i = 0; i < 100; ++i) {
      passed += passesThrough(shotAt(target, preset, physics, speed, rng), speed) ? 1 : 0;
    }
  }
  CHECK(passed == 0);
}

TEST_CASE("no ball passes through a wall up to the profile's ball speed", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  Rng rng(7, kTestStream);
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

TEST_CASE("random driving leaves everything inside the walls", "[unit][repeated]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  World world = makeWorld(matchConfig(preset, physics, 3, {}));
  Rng rng(1, Stream::kWheelCommands);
  std::vector<WheelSpeeds> commands(6);
  int outside = 0;
  for (int tick = 0; tick < 25'000 * repetitions(); ++tick) {
    // One robot per tick gets new wheel speeds, so that each keeps its speeds long enough to go somewhere.
    WheelSpeeds& wheels = commands[rng.below(6)];
    wheels = {rng.uniform(-46.0, 46.0), rng.uniform(-46.0, 46.0)};
    if (tick % 6'000 == 0) world = makeWorld(matchConfig(preset, physics, 3, {}));
    world.step(commands);
    if (!allInside(world)) ++outside;
  }
  CHECK(outside == 0);
}

TEST_CASE("robots that all push the ball into walls and corners leave nothing outside", "[unit][repeated]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  World world = makeWorld(matchConfig(vsssPreset(), physics, 3, {}));
  std::vector<WheelSpeeds> commands(6);
  int outside = 0;
  for (int tick = 0; tick < 10'000 * repetitions(); ++tick) {
    const WorldState& state = world.state();
    for (std::size_t i = 0; i < 6; ++i) commands[i] = chase(state.robots[i], state.balls[0].position);
    world.step(commands);
    if (!allInside(world)) ++outside;
  }
  CHECK(outside == 0);
}
