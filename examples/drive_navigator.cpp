// Drives one robot round an obstacle to a goal. Try other methods: drive_navigator bezier:clearance=0.03
#include <cstdio>
#include <fulbito/navigation.hpp>
#include <fulbito/world.hpp>

int main(int count, char** arguments) {
  const auto choice = fulbito::parseNavigator(count > 1 ? arguments[1] : fulbito::kDefaultNavigator);
  if (!choice) return std::fprintf(stderr, "%s\n", choice.error().message.c_str()), 2;
  const auto pilot = fulbito::makePilot(*choice);

  fulbito::WorldConfig config;
  config.robots.emplace_back().pose.position = {-0.5, 0.0};
  config.obstacles.emplace_back().pose.position = {0.0, 0.02};
  auto world = fulbito::World::create(config);
  if (!pilot || !world) return 1;

  const fulbito::ObstacleSpec& ball = config.obstacles[0];
  const fulbito::DiscObstacle disc{ball.pose.position, ball.radius, {}};
  fulbito::NavigationScene scene;
  scene.dt = config.physics.controlPeriod();
  scene.field = &config.field;
  scene.robot = &config.robots[0].model;
  scene.obstacles = {&disc, 1};
  scene.goal.position = {0.5, 0.0};
  while (scene.tick < 10 * config.physics.control_rate) {
    scene.tick = world->state().tick;
    scene.self = world->state().robots[0];
    if (distance(scene.self.pose.position, scene.goal.position) < scene.goal.tolerance) {
      return std::printf("%s: there after %.2f s\n", choice->text.c_str(), scene.dt * scene.tick), 0;
    }
    const fulbito::WheelSpeeds wheels = (*pilot)->drive(scene);
    world->step({&wheels, 1});
  }
  return std::printf("%s: not there after 10 s\n", choice->text.c_str()), 1;
}
