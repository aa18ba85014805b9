#include <cmath>

#include "engine/sim/obstacle_motion.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

WorldConfig lone(const ObstacleSpec& obstacle) {
  WorldConfig config{wideField(), standardPhysics(), {}, {}, {}};
  config.obstacles.push_back(obstacle);
  return config;
}

ObstacleSpec patrol(PathEnd end) {
  ObstacleSpec disc = discAt({}, ObstacleMotion::kPath);
  disc.path = {{0.0, 0.0}, {0.31, 0.0}, {0.31, 0.17}};
  disc.speed = 0.37;
  disc.path_end = end;
  return disc;
}

}  // namespace

TEST_CASE("an obstacle on a path is where its path says, also after minutes", "[unit]") {
  const auto end = GENERATE(PathEnd::kBounce, PathEnd::kCycle, PathEnd::kStop);
  const ObstacleSpec spec = patrol(end);
  World world = makeWorld(lone(spec));
  double worst = 0.0;
  for (int tick = 1; tick <= 60 * 300; ++tick) {
    run(world, {}, 1);
    const Vec2 wanted = positionAt(spec, tick / 60.0);
    worst = std::max(worst, distance(world.state().obstacles[0].pose.position, wanted));
  }
  CHECK(worst <= 1e-6);
}

TEST_CASE("an obstacle on a path pushes what is in its way and is not slowed", "[unit]") {
  const ObstacleSpec spec = patrol(PathEnd::kStop);
  WorldConfig config = lone(spec);
  config.balls.push_back({vsssPreset().ball, {0.15, 0.0}, {}, {}});
  World world = makeWorld(config);
  run(world, {}, 30);
  CHECK(world.state().balls[0].position.x > 0.185 + 0.05);
  CHECK(distance(world.state().obstacles[0].pose.position, positionAt(spec, 0.5)) <= 1e-6);
}

TEST_CASE("a pushable obstacle slides on as far as the floor's friction lets it", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, faithfulPhysics());
  config.robots[0].velocity = {1.0, 0.0};
  config.obstacles.push_back(discAt({0.1, 0.0}, ObstacleMotion::kPushable));
  World world = makeWorld(config);
  while (world.contacts().empty()) run(world, {}, 1);
  const ObstacleState struck = world.state().obstacles[0];
  run(world, {}, 240);
  const ObstacleState rest = world.state().obstacles[0];
  CHECK(struck.velocity.x > 0.5);
  CHECK(norm(rest.velocity) == Approx(0.0).margin(1e-6));
  const double expected = squaredNorm(struck.velocity) / (2 * 0.5);
  CHECK(rest.pose.position.x - struck.pose.position.x == Approx(expected).epsilon(0.02));
}

TEST_CASE("a pushable obstacle that nobody pushes stays, a fixed one stays whatever happens", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.obstacles = {discAt({0.2, 0.0}), discAt({0.2, 1.0}, ObstacleMotion::kPushable)};
  World world = makeWorld(config);
  run(world, {30.0, 30.0}, 300);
  CHECK(world.state().obstacles[0].pose.position.x == Approx(0.2).margin(1e-6));
  CHECK(world.state().obstacles[1].pose.position.y == Approx(1.0).margin(1e-6));
  CHECK(world.state().robots[0].pose.position.x < 0.2);
}

TEST_CASE("a turning disc of even density loses 4/3 of the floor's friction over its radius", "[unit]") {
  ObstacleSpec disc = discAt({});
  disc.radius = 0.03;
  disc.mass = 0.2;
  disc.floor_friction = 0.6;
  CHECK(inertiaOf(disc) == Approx(0.5 * 0.2 * 0.0009));
  CHECK(yawDeceleration(disc) == Approx(4.0 / 3.0 * 0.6 / 0.03));
  disc.shape = ObstacleShape::kBox;
  disc.length = 0.08;
  disc.width = 0.06;
  CHECK(inertiaOf(disc) == Approx(0.2 * 0.01 / 12));
}
