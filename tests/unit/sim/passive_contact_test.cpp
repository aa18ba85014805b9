#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

// Robots and balls on ice: no motor, no grip, no friction with the floor, so that only contacts
// can change the energy.
WorldConfig onIce(const PhysicsProfile& physics, std::uint64_t seed) {
  WorldConfig config = matchConfig(vsssPreset(), readEachStep(physics), 3, {});
  Rng rng(seed, Stream::kTest);
  const auto velocity = [&] { return Vec2{rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)}; };
  for (RobotPlacement& robot : config.robots) {
    robot.model.wheel_acceleration = robot.model.wheel_braking = 0.0;
    robot.model.lateral_grip = 0.0;
    robot.velocity = velocity();
    robot.angular_velocity = rng.uniform(-20.0, 20.0);
  }
  for (double y : {-0.3, 0.3}) config.balls.push_back({vsssPreset().ball, {0.0, y}, {}, {}});
  for (BallPlacement& ball : config.balls) {
    ball.model.roll_keep = 1.0;
    ball.model.roll_deceleration = ball.model.stop_speed = 0.0;
    ball.velocity = velocity();
  }
  return config;
}

double energy(const World& world) {
  const WorldConfig& config = world.config();
  const WorldState& state = world.state();
  double sum = 0.0;
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const RobotModel& m = config.robots[i].model;
    const double inertia = m.mass * (m.length * m.length + m.width * m.width) / 12;
    const double yaw = state.robots[i].angular_velocity;
    sum += (m.mass * squaredNorm(state.robots[i].velocity) + inertia * yaw * yaw) / 2;
  }
  for (std::size_t i = 0; i < state.balls.size(); ++i)
    sum += config.balls[i].model.mass * squaredNorm(state.balls[i].velocity) / 2;
  return sum;
}

}  // namespace

TEST_CASE("contacts without motors create no energy beyond rounding", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  double worst = 0.0;
  double started = 0.0, ended = 0.0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    World world = makeWorld(onIce(physics, seed));
    double before = energy(world);
    started += before;
    for (int step = 0; step < 600; ++step) {
      run(world, {}, 1);
      const double now = energy(world);
      worst = std::max(worst, (now - before) / before);
      before = now;
    }
    ended += before;
  }
  CHECK(worst <= 1e-5);
  CHECK(ended < 0.5 * started);  // they did collide
}
