// Robots that push on each other: who wins does not depend on which one the world lists first.
#include <array>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/energy.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

struct Pusher {
  RobotPlacement robot;
  WheelSpeeds wheels;
};

/// A robot that drives at the origin along the direction, a little off and askew.
Pusher pusher(const RobotPreset& preset, double toward, Rng& rng) {
  const double gap = preset.robot.length / 2 + rng.uniform(0.002, 0.03);
  const Vec2 ahead = math::unit(toward);
  const Vec2 from = perp(ahead) * rng.uniform(-0.02, 0.02) - ahead * gap;
  const double heading = math::wrapAngle(toward + rng.uniform(-0.05, 0.05));
  const double speed = 0.8 * preset.robot.maxSpeed() / preset.robot.wheel_radius;
  const double turn = rng.uniform(-0.05, 0.05);
  return {{preset.robot, {from, heading}, {}, 0.0}, {speed * (1.0 - turn), speed * (1.0 + turn)}};
}

/// Poses of both after a second, in the order of the list.
std::array<Pose2, 2> push(const std::array<Pusher, 2>& list, const PhysicsProfile& physics) {
  WorldConfig config{wideField(), physics, {}, {}, {}};
  std::vector<WheelSpeeds> wheels;
  for (const Pusher& one : list) {
    config.robots.push_back(one.robot);
    wheels.push_back(one.wheels);
  }
  World world = makeWorld(config);
  for (int tick = 0; tick < 60; ++tick) world.step(wheels);
  return {world.state().robots[0].pose, world.state().robots[1].pose};
}

}  // namespace

TEST_CASE("robots that push each other move alike whichever is listed first", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset(), paperPreset());
  CAPTURE(physics.name, preset.robot.name);
  Rng rng(67, kTestStream);
  constexpr int kScenes = 200;
  double apart = 0.0;
  for (int scene = 0; scene < kScenes; ++scene) {
    const double toward = rng.uniform(-math::kPi, math::kPi);
    const Pusher a = pusher(preset, toward, rng), b = pusher(preset, toward + math::kPi, rng);
    const auto first = push({a, b}, physics), second = push({b, a}, physics);
    apart += norm(first[0].position - second[1].position) / kScenes;
  }
  CHECK(apart < 0.00001);  // rounding only: a few scenes amplify it
}
