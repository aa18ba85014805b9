// A module as a binding generator would build it: everything hidden but one function.
#include <algorithm>

#include "fulbito/world.hpp"

/// Box2D's own measurement of a step of a small world [ms].
extern "C" __attribute__((visibility("default"))) float moduleStepMilliseconds() {
  fulbito::WorldConfig config;
  config.robots.resize(1);
  auto world = fulbito::World::create(config);
  if (!world) return -1.0f;
  float longest = 0.0f;
  for (int i = 0; i < 1000; ++i) {
    world->step({});
    longest = std::max(longest, world->engineProfileMilliseconds());
  }
  return longest;
}
