#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

const BallState& ballOf(const World& world) { return world.state().balls[0]; }
bool rolls(const BallState& ball) { return norm(ball.velocity - ball.spin) < 1e-4; }
double secondsOf(const World& world) {
  return static_cast<double>(world.state().tick) * world.config().physics.controlPeriod();
}

// Runs until the ball rolls without sliding. @return its speed along x then
double settledSpeed(World& world) {
  for (int i = 0; i < 4000; ++i) {
    run(world, {}, 1);
    if (rolls(ballOf(world))) break;
  }
  return ballOf(world).velocity.x;
}

double rollDistance(const BallModel& model, const PhysicsProfile& physics, double speed) {
  World world = makeWorld(loneBall(model, physics, {speed, 0.0}, {}));
  for (int i = 0; i < 60 * 60 && ballOf(world).velocity.x > 0.0; ++i) run(world, {}, 1);
  return ballOf(world).position.x;
}

struct Rebound {
  double at_once;  // [m/s] away from the wall, right after the impact
  double settled;
};

// A ball that rolls at 1 m/s into the right wall.
Rebound rebound(const BallModel& model, const PhysicsProfile& physics) {
  WorldConfig config = loneBall(model, readEachStep(physics), {1.0, 0.0}, {1.0, 0.0});
  config.balls[0].position = {config.field.length / 2 - 0.05, 0.0};
  World world = makeWorld(config);
  while (ballOf(world).velocity.x > 0.0) run(world, {}, 1);
  const double at_once = -ballOf(world).velocity.x;
  return {at_once, -settledSpeed(world)};
}

struct Push {
  double robot_at_once;
  double ball_at_once;
  double robot_later;  // 0.2 s after the impact
  double ball_later;
};

Push push(const RobotPreset& preset, const PhysicsProfile& physics, double speed) {
  WorldConfig config = loneRobot(preset.robot, readEachStep(physics));
  config.robots[0].velocity = {speed, 0.0};
  config.balls.push_back({preset.ball, {0.08, 0.0}, {}, {}});
  World world = makeWorld(config);
  const WheelSpeeds command{speed / preset.robot.wheel_radius, speed / preset.robot.wheel_radius};
  while (ballOf(world).velocity.x == 0.0) run(world, command, 1);
  Push result{};
  result.robot_at_once = world.state().robots[0].velocity.x;
  result.ball_at_once = ballOf(world).velocity.x;
  run(world, command, config.physics.control_rate / 5);
  result.robot_later = world.state().robots[0].velocity.x;
  result.ball_later = ballOf(world).velocity.x;
  return result;
}

}  // namespace

TEST_CASE("a kicked ball slides, then rolls with the measured share of its speed", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  World vsss = makeWorld(loneBall(vsssPreset().ball, readEachStep(physics), {1.0, 0.0}, {}));
  CHECK(settledSpeed(vsss) == Approx(0.69).epsilon(0.02));
  World firasim = makeWorld(loneBall(firasimPreset().ball, readEachStep(physics), {1.5, 0.0}, {}));
  CHECK(settledSpeed(firasim) == Approx(0.70 * 1.5).epsilon(0.02));
  CHECK(secondsOf(firasim) <= 0.2);
}

TEST_CASE("a rolling ball loses speed at the measured rate and comes to rest", "[unit]") {
  const auto loss = [](const BallModel& model) {
    World world = makeWorld(loneBall(model, standardPhysics(), {1.0, 0.0}, {1.0, 0.0}));
    run(world, {}, 60);
    return 1.0 - ballOf(world).velocity.x;
  };
  CHECK(loss(vsssPreset().ball) == Approx(0.140).epsilon(0.005));
  CHECK(loss(firasimPreset().ball) == Approx(0.0756).epsilon(0.005));
}

TEST_CASE("a ball kicked at 1 m/s comes to rest where the measured figures put it", "[unit]") {
  // Sliding from 1 m/s to k at 3 m/s2, then k^2 / 2a of rolling.
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CHECK(rollDistance(vsssPreset().ball, physics, 1.0) == Approx(0.0873 + 1.7004).epsilon(0.01));
  CHECK(rollDistance(firasimPreset().ball, physics, 1.0) == Approx(0.0850 + 3.2407).epsilon(0.01));
}

TEST_CASE("a ball leaves a wall as measured, at once and after its spin has settled", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  const Rebound vsss = rebound(vsssPreset().ball, physics);
  CHECK(vsss.at_once == Approx(0.50).epsilon(0.05));
  CHECK(vsss.settled == Approx(0.25).epsilon(0.05));
  const Rebound firasim = rebound(firasimPreset().ball, physics);
  CHECK(firasim.at_once == Approx(0.50).epsilon(0.05));
  CHECK(firasim.settled == Approx(0.28).epsilon(0.05));
}

TEST_CASE("a robot that runs into a resting ball shares its speed as measured", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  const Push vsss = push(vsssPreset(), physics, 0.78);
  CHECK(vsss.robot_at_once == Approx(0.56).epsilon(0.05));
  CHECK(vsss.ball_at_once == Approx(0.59).epsilon(0.05));
  CHECK(vsss.robot_later == Approx(0.78).epsilon(0.05));
  CHECK(vsss.ball_later == Approx(0.78).epsilon(0.05));

  const Push firasim = push(firasimPreset(), physics, 0.4);
  CHECK(firasim.ball_at_once >= 1.03 * 0.4);
  CHECK(firasim.ball_at_once <= 1.07 * 0.4);
  CHECK(firasim.robot_at_once == Approx(0.4).epsilon(0.05));
}
