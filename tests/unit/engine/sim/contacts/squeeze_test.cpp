// Robots that close on a ball from two or three sides: the speed that they give it has a bound.
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/energy.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

/// Two robots drive at a slow ball with nearly parallel fronts; often a third one comes from the side.
WorldConfig jaws(const RobotPreset& preset, const PhysicsProfile& physics, Rng& rng) {
  WorldConfig config{wideField(), readEachStep(physics), {}, {}, {}};
  const double across = rng.uniform(-math::kPi, math::kPi);
  const double gap = preset.ball.radius + preset.robot.length / 2;
  const int robots = rng.uniform(0.0, 1.0) < 0.3 ? 3 : 2;
  for (int i = 0; i < robots; ++i) {
    const double from = i < 2 ? across + i * math::kPi : across + math::kPi / 2;
    const double heading = math::wrapAngle(from + math::kPi + rng.uniform(-0.25, 0.25));
    const Vec2 velocity = math::unit(heading) * (rng.uniform(0.3, 1.0) * preset.robot.maxSpeed());
    const double reach = i < 2 ? gap + rng.uniform(0.002, 0.03) : 2 * gap + preset.robot.circumradius();
    config.robots.push_back({preset.robot, {math::unit(from) * reach, heading}, velocity, 0.0});
  }
  const Vec2 velocity{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
  config.balls.push_back({preset.ball, {}, velocity, velocity});
  return config;
}

bool isSqueezed(const World& world) {
  const auto of_ball = [](const ContactEvent& e) { return e.b.kind == BodyKind::kBall; };
  return std::count_if(world.contacts().begin(), world.contacts().end(), of_ball) > 1;
}

Vec2 momentum(const World& world) {
  Vec2 sum = world.state().balls[0].velocity * world.config().balls[0].model.mass;
  for (std::size_t i = 0; i < world.state().robots.size(); ++i)
    sum = sum + world.state().robots[i].velocity * world.config().robots[i].model.mass;
  return sum;
}

/// Removes motors, grip and friction with the floor.
void putOnIce(WorldConfig& config) {
  for (RobotPlacement& robot : config.robots) {
    robot.model.wheel_acceleration = robot.model.wheel_braking = robot.model.rolling_drag = 0.0;
    robot.model.lateral_grip = robot.model.wheel_width = robot.model.mass_height = 0.0;
  }
  config.balls[0].model.roll_keep = 1.0;
  config.balls[0].model.roll_deceleration = config.balls[0].model.stop_speed = 0.0;
}

}  // namespace

TEST_CASE("robots squeeze a ball out no faster than two impacts of the fastest surface", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset(), paperPreset());
  CAPTURE(physics.name, preset.robot.name);
  Rng rng(61, kTestStream);
  int squeezes = 0;
  double worst = -1.0;
  for (int scene = 0; scene < 250; ++scene) {
    World world = makeWorld(jaws(preset, physics, rng));
    std::vector<WheelSpeeds> onward;
    for (const RobotState& robot : world.state().robots) onward.push_back(robot.wheels);
    for (int step = 0; step < 15; ++step) {
      const double speed = norm(world.state().balls[0].velocity), surface = fastestSurface(world);
      world.step(onward);
      if (!isSqueezed(world)) continue;
      ++squeezes;
      // In a step, motors and floor act before the bodies meet.
      const double dt = world.config().physics.stepPeriod();
      const double push = preset.robot.wheel_acceleration * dt, slide = preset.ball.slide_deceleration * dt;
      const double fastest = std::max(surface + push, fastestSurface(world));
      const double most = speed + slide + 2 * (1 + preset.ball.robot_restitution) * fastest;
      worst = std::max(worst, norm(world.state().balls[0].velocity) - std::max(most, 0.1));
    }
  }
  CHECK(squeezes > 200);
  CHECK(worst <= 0.01);
}

TEST_CASE("a squeezed ball that is slowed gives its momentum to what holds it, and no energy", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics());
  CAPTURE(physics.name);
  const RobotPreset preset = firasimPreset();
  Rng rng(62, kTestStream);
  int squeezes = 0;
  double changed = 0.0, gained = 0.0;
  for (int scene = 0; scene < 250; ++scene) {
    WorldConfig config = jaws(preset, physics, rng);
    putOnIce(config);
    World world = makeWorld(config);
    for (int step = 0; step < 15; ++step) {
      const Vec2 before = momentum(world);
      const double energy_before = energy(world);
      run(world, {}, 1);
      squeezes += isSqueezed(world) ? 1 : 0;
      changed = std::max(changed, norm(momentum(world) - before));
      gained = std::max(gained, energy(world) - energy_before);
    }
  }
  CHECK(squeezes > 200);
  CHECK(changed <= 1e-4);
  CHECK(gained <= 1e-4);
}
