// An outside project: a world, a navigator, a match. Fails when Box2D still reads its clock.
#include <cstdio>
#include <fulbito/match.hpp>
#include <fulbito/navigation.hpp>
#include <fulbito/statistics.hpp>
#include <fulbito/world.hpp>

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

  const auto match_config = fulbito::MatchConfig::standard("libero", "classic");
  if (!match_config) return 1;
  auto match = fulbito::Match::create(*match_config);
  if (!match) return 1;
  fulbito::StatisticsObserver statistics;
  match->watch(statistics);
  for (int i = 0; i < 600; ++i) match->step();
  std::printf("match %016llx, %d touches\n", static_cast<unsigned long long>(match->hash()),
              statistics.statistics().teams[0].touches());
  return moved && match->tick() == 600 && world->engineProfileMilliseconds() == 0.0f ? 0 : 1;
}
