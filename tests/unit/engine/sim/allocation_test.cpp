// Counts every allocation of the program: Box2D uses malloc, the library operator new, and both end here.
#include <cstdlib>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/sensors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/malloc_counter.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

enum class Load { kRandom, kChase };

// Number of allocations in `ticks` ticks after `warm_up` ticks.
long allocationsIn(World& world, Load load, int warm_up, int ticks) {
  Rng rng(5, Stream::kWheelCommands);
  std::vector<WheelSpeeds> commands(world.config().robots.size());
  long before = 0;
  for (int tick = 0; tick < warm_up + ticks; ++tick) {
    if (tick == warm_up) before = mallocCount();
    for (std::size_t i = 0; i < commands.size(); ++i) {
      commands[i] = load == Load::kChase ? chase(world.state().robots[i], world.state().balls[0].position)
                                         : WheelSpeeds{rng.uniform(-46.0, 46.0), rng.uniform(-46.0, 46.0)};
    }
    world.step(commands);
  }
  return mallocCount() - before;
}

}  // namespace

TEST_CASE("the counter sees what malloc and operator new allocate", "[unit]") {
  const long before = mallocCount();
  void* volatile raw = std::malloc(10);  // volatile: the compiler may not drop the pair
  std::free(raw);
  std::vector<int>* volatile made = new std::vector<int>(100);
  delete made;
  CHECK(mallocCount() - before >= 3);
}

TEST_CASE("a warm world's ticks allocate nothing", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto load = GENERATE(Load::kRandom, Load::kChase);
  CAPTURE(physics.name, static_cast<int>(load));
  World small = makeWorld(matchConfig(vsssPreset(), physics, 3, {}));
  CHECK(allocationsIn(small, load, 600, 6'000) == 0);

  WorldConfig config = matchConfig(vsssPreset(), physics, 5, largeField());
  for (int i = 0; i < 9; ++i) {
    const Vec2 at{-0.8 + 0.2 * i, 0.75};
    config.obstacles.push_back(discAt(at, static_cast<ObstacleMotion>(i % 3)));
    config.obstacles.back().path = {at, {at.x, 0.3}};
  }
  World large = makeWorld(config);
  CHECK(allocationsIn(large, load, 600, 3'000) == 0);
}

TEST_CASE("warm sonars allocate nothing", "[unit]") {
  World world = makeWorld(matchConfig(vsssPreset(), standardPhysics(), 3, {}));
  SonarModel model;
  model.sonars.resize(8);
  for (std::size_t i = 0; i < 8; ++i) model.sonars[i].mount.heading = 0.7 * static_cast<double>(i) - 3.0;
  model.noise = 0.005;
  model.cross_talk = 0.1;
  SonarArray sonars({}, model, {1, Stream::kSonar});
  long before = 0;
  for (int tick = 0; tick < 300; ++tick) {
    if (tick == 10) before = mallocCount();
    world.step({});
    sonars.measure(world, 0);
  }
  CHECK(mallocCount() == before);
}

TEST_CASE("robots that carry a rod allocate nothing", "[unit]") {
  WorldConfig config = matchConfig(vsssPreset(), standardPhysics(), 3, largeField());
  config.robots[0].pose = {{-0.2, 0.0}, 0.0};
  config.robots[1].pose = {{0.2, 0.0}, 0.0};
  config.rods.push_back({0, 1, 0.4, 0.1});
  World world = makeWorld(config);
  CHECK(allocationsIn(world, Load::kRandom, 600, 6'000) == 0);
}
