// An outside project: a world, a navigator, a few ticks. Fails when Box2D still reads its clock.
#include <cstdio>
#include <fulbito/engine/core/base/hash.hpp>
#include <fulbito/engine/sim/world.hpp>
#include <fulbito/navigation/registry.hpp>

int main() {
  fulbito::WorldConfig config;
  config.robots.emplace_back();
  config.balls.emplace_back().position = {0.2, 0.1};
  auto world = fulbito::World::create(config);
  auto pilot = fulbito::makePilot(*fulbito::parseNavigator(fulbito::kDefaultNavigator));
  if (!world || !pilot) return 1;
  fulbito::NavigationScene scene;
  scene.field = &config.field;
  scene.robot = &config.robots.front().model;
  scene.goal.position = {0.5, 0.3};
  for (int i = 0; i < 120; ++i) {
    scene.tick = world->state().tick;
    scene.self = world->state().robots.front();
    const fulbito::WheelSpeeds command = (*pilot)->drive(scene);
    world->step({&command, 1});
  }
  fulbito::StateHash hash;
  hash.add(world->state());
  std::printf("state %016llx, Box2D's profile %g ms\n", static_cast<unsigned long long>(hash.value()),
              static_cast<double>(world->engineProfileMilliseconds()));
  const bool moved = fulbito::norm(world->state().robots.front().pose.position) > 0.1;
  return moved && world->engineProfileMilliseconds() == 0.0f ? 0 : 1;
}
