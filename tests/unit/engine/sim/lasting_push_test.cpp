// Motors and tyres hold a robot against contacts that last, however long the physics steps are.
#include "engine/sim/lasting_push.hpp"

#include <cmath>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

TEST_CASE("a push is expected once it has lasted two steps, and at most as strong as in both", "[unit]") {
  LastingPush push;
  const BodyMotion driven{0.5, 0.0, 1.0};
  push.measure(driven, {0.3, 0.02, 0.4});
  CHECK(push.expected().sideways == 0.0);
  CHECK(push.expected().yaw == 0.0);
  push.measure(driven, {0.3, 0.03, 0.8});
  CHECK(push.expected().sideways == Approx(0.018));
  CHECK(push.expected().yaw == Approx(-0.18));
  CHECK(push.expected().forward == Approx(-0.18));
  push.measure(driven, {0.3, -0.03, 1.0});
  CHECK(push.expected().sideways == 0.0);
  CHECK(push.expected().yaw == 0.0);
}

namespace {

/// A standing robot, and one that pushes it across its wheels, `off` [m] beside its middle.
WorldConfig pushedFromTheSide(const RobotPreset& preset, const PhysicsProfile& physics, double off) {
  WorldConfig config{wideField(), physics, {}, {}, {}};
  config.robots.push_back({preset.robot, {{0.0, 0.0}, math::kPi / 2}, {}, 0.0});
  config.robots.push_back({preset.robot, {{-preset.robot.length - 0.001, off}, 0.0}, {}, 0.0});
  return config;
}

}  // namespace

TEST_CASE("a robot that stands holds against a push that is weaker than its tyres' grip", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  const double off = GENERATE(-0.01, 0.01);
  CAPTURE(physics.name, preset.robot.name, off);
  World world = makeWorld(pushedFromTheSide(preset, physics, off));
  const double wheels = 0.5 * preset.robot.maxSpeed() / preset.robot.wheel_radius;
  const std::vector<WheelSpeeds> commands{{}, {wheels, wheels}};
  const auto step = [&](double seconds) {
    for (int tick = 0; tick < seconds * physics.control_rate; ++tick) world.step(commands);
    return world.state().robots[0].pose;
  };
  const Pose2 hit = step(0.5), held = step(1.0);
  // A robot that only answers what is left of the step before goes on at the speed that a step gives it.
  const double yields = preset.robot.wheel_acceleration * physics.stepPeriod();
  CHECK(distance(hit.position, held.position) < 0.12 * yields);
  CHECK(std::abs(math::wrapAngle(held.heading - hit.heading)) < 0.4 * yields);
}
