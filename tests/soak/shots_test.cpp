#include "tests/support/shots.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

// The promise of docs/models.md at full length; the engine's tests shoot a hundred balls of other seeds.
TEST_CASE("none of 4,000 balls per speed passes through robots", "[soak]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  const auto target = GENERATE(ShotTarget::kRobot, ShotTarget::kTwoRobots, ShotTarget::kRobotAtWall);
  const auto speed = GENERATE(4.0, 6.0, 8.0, 10.0);
  if (speed > physics.max_ball_speed) return;
  CAPTURE(physics.name, preset.robot.name, static_cast<int>(target), speed);
  Rng rng(4000, kTestStream);
  int passed = 0;
  for (int i = 0; i < 4000; ++i) {
    passed += passesThrough(shotAt(target, preset, physics, speed, rng), speed) ? 1 : 0;
  }
  CHECK(passed == 0);
}
