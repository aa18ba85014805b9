#include "experiments/trials/sensing.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

TrialConfig configWith(SensorModel sensors) {
  TrialConfig config;
  config.sensors = sensors;
  config.layout.obstacles.emplace_back();
  return config;
}

WorldState worldAt(double x, Vec2 obstacle, Vec2 obstacle_velocity) {
  WorldState world;
  world.robots.resize(1);
  world.robots[0].pose.position = {x, 0.0};
  world.obstacles.resize(1);
  world.obstacles[0] = {{obstacle, 0.0}, obstacle_velocity};
  return world;
}

}  // namespace

TEST_CASE("without latency and noise the observation is the truth", "[unit]") {
  const TrialConfig config = configWith({});
  Sensing sensing(config);
  sensing.observe(worldAt(0.25, {0.1, 0.2}, {0.3, 0.0}));
  CHECK(sensing.robot().pose.position == Vec2{0.25, 0.0});
  REQUIRE(sensing.obstacles().size() == 1);
  CHECK(sensing.obstacles()[0].position == Vec2{0.1, 0.2});
}

TEST_CASE("a late observation is rolled forward through the commands given since", "[unit]") {
  TrialConfig config = configWith({3, 0.0});
  const RobotModel& robot = config.robot.robot;
  const double dt = config.physics.controlPeriod();
  Sensing sensing(config);
  // The truth follows the same motor model, so the prediction must be exact.
  WorldState world = worldAt(0.0, {0.0, 0.3}, {0.5, 0.0});
  sensing.observe(world);
  for (int i = 0; i < 30; ++i) {
    const WheelSpeeds command{20.0 + i, 15.0};
    sensing.commanded(command);
    world.robots[0] = rolledForward(robot, world.robots[0], command, dt);
    world.obstacles[0].pose.position += world.obstacles[0].velocity * dt;
    sensing.observe(world);
    CHECK(distance(sensing.robot().pose.position, world.robots[0].pose.position) < 1e-12);
    CHECK(std::abs(math::wrapAngle(sensing.robot().pose.heading - world.robots[0].pose.heading)) < 1e-12);
    CHECK(distance(sensing.obstacles()[0].position, world.obstacles[0].pose.position) < 1e-12);
  }
}

TEST_CASE("noise has the standard deviation asked for and belongs to the trial's stream", "[unit]") {
  TrialConfig config = configWith({0, 0.004});
  Sensing sensing(config), again(config);
  double sum = 0.0, square = 0.0;
  const int n = 4000;
  for (int i = 0; i < n; ++i) {
    sensing.observe(worldAt(0.0, {}, {}));
    again.observe(worldAt(0.0, {}, {}));
    CHECK(sensing.robot().pose.position == again.robot().pose.position);
    sum += sensing.robot().pose.position.x;
    square += sensing.robot().pose.position.x * sensing.robot().pose.position.x;
  }
  CHECK(std::abs(sum / n) < 4 * 0.004 / std::sqrt(n));
  CHECK(std::sqrt(square / n) == Approx(0.004).epsilon(0.05));
}

TEST_CASE("a body that drops out stays where it was seen last; at the start all are seen", "[unit]") {
  SensorModel sensors;
  sensors.dropout = 0.3;
  TrialConfig config = configWith(sensors);
  const int n = 4000;
  int stale_robot = 0, stale_obstacle = 0;
  for (config.index = 0; config.index < 20; ++config.index) {
    Sensing sensing(config);
    double robot = 0.0, obstacle = 0.0;
    for (int i = 0; i < n / 20; ++i) {
      const double x = 0.001 * (i + 1);
      sensing.observe(worldAt(x, {-x, 0.3}, {}));
      const double robot_now = sensing.robot().pose.position.x,
                   obstacle_now = sensing.obstacles()[0].position.x;
      REQUIRE((robot_now == x || (i > 0 && robot_now == robot)));
      REQUIRE((obstacle_now == -x || (i > 0 && obstacle_now == obstacle)));
      stale_robot += robot_now == x ? 0 : 1;
      stale_obstacle += obstacle_now == -x ? 0 : 1;
      robot = robot_now;
      obstacle = obstacle_now;
    }
  }
  // Four standard deviations of a binomial count are 116.
  CHECK(stale_robot == Approx(0.3 * n).margin(116));
  CHECK(stale_obstacle == Approx(0.3 * n).margin(116));
}

TEST_CASE("boxes are covered by discs", "[unit]") {
  ObstacleSpec box;
  box.shape = ObstacleShape::kBox;
  box.length = 0.30;
  box.width = 0.10;
  std::vector<DiscObstacle> discs;
  appendDiscs(box, {{{0.5, 0.5}, math::kPi / 2}, {}}, discs);
  REQUIRE(discs.size() == 3);
  for (Vec2 corner :
       {Vec2{0.45, 0.35}, Vec2{0.55, 0.35}, Vec2{0.45, 0.65}, Vec2{0.55, 0.65}, Vec2{0.55, 0.45}}) {
    double nearest = 1e9;
    for (const DiscObstacle& d : discs) nearest = std::min(nearest, distance(d.position, corner) - d.radius);
    CHECK(nearest < 1e-12);
  }
}

}  // namespace fulbito
