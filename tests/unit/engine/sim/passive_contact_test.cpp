#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/energy.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

enum class Scene { kOpen, kIntoCorner };

// Robots and balls on ice: no motor, no grip, no friction with the floor, so that only contacts
// can change the energy.
WorldConfig onIce(const RobotPreset& preset, const PhysicsProfile& physics, int per_team, Scene scene,
                  std::uint64_t seed) {
  WorldConfig config = matchConfig(preset, readEachStep(physics), per_team, largeField());
  Rng rng(seed, kTestStream);
  const auto velocity = [&] { return Vec2{rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)}; };
  int number = 0;
  for (RobotPlacement& robot : config.robots) {
    robot.model.wheel_acceleration = robot.model.wheel_braking = robot.model.rolling_drag = 0.0;
    robot.model.lateral_grip = robot.model.wheel_width = robot.model.mass_height = 0.0;
    robot.velocity = velocity();
    robot.angular_velocity = rng.uniform(-20.0, 20.0);
    if (scene == Scene::kIntoCorner) {
      robot.pose.position = {0.45 + 0.11 * (number % 5), 0.3 + 0.12 * (number / 5)};
      robot.velocity = unitOr(Vec2{1.1, 0.9} - robot.pose.position, {}) * rng.uniform(1.0, 2.0);
    }
    ++number;
  }
  for (double y : {-0.3, 0.1}) config.balls.push_back({preset.ball, {0.0, y}, {}, {}});
  for (BallPlacement& ball : config.balls) {
    ball.model.roll_keep = 1.0;
    ball.model.roll_deceleration = ball.model.stop_speed = 0.0;
    ball.velocity = velocity();
  }
  return config;
}

}  // namespace

TEST_CASE("contacts without motors create no energy beyond rounding", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset(), paperPreset());
  const int per_team = GENERATE(3, 5);
  const auto scene = GENERATE(Scene::kOpen, Scene::kIntoCorner);
  CAPTURE(physics.name, preset.robot.name, per_team, static_cast<int>(scene));
  double worst = 0.0, worst_scene = 0.0;
  double started = 0.0, ended = 0.0;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    World world = makeWorld(onIce(preset, physics, per_team, scene, seed));
    double before = energy(world), gained = 0.0;
    const double start = before;
    started += start;
    for (int step = 0; step < 400; ++step) {
      run(world, {}, 1);
      const double now = energy(world);
      worst = std::max(worst, (now - before) / std::max(before, 1e-3));
      gained += std::max(0.0, now - before);
      before = now;
    }
    worst_scene = std::max(worst_scene, gained / start);
    ended += before;
  }
  CHECK(worst <= 1e-5);
  CHECK(worst_scene <= 1e-5);
  CHECK(ended < 0.8 * started);  // they did collide
}
