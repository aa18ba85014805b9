#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kGap = 0.0016;  // [m] the engine may keep bodies apart, or let them overlap, by at most this
constexpr double kHalf = 0.0375;
constexpr double kBallRadius = 0.0215;
constexpr WheelSpeeds kForward{20.0, 20.0};

WorldConfig facingRight(const PhysicsProfile& physics, double x) {
  WorldConfig config{{}, physics, {}, {}, {}};
  config.robots.push_back({vsssPreset().robot, {{x, 0.4}, 0.0}, {}, 0.0});
  return config;
}

double robotX(const World& world, std::size_t i = 0) { return world.state().robots[i].pose.position.x; }

}  // namespace

TEST_CASE("bodies pressed together touch within 1.6 mm of their outlines", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  WorldConfig config = facingRight(physics, 0.55);
  const double wall = config.field.length / 2;

  SECTION("a robot and a wall") {
    World world = makeWorld(config);
    run(world, kForward, 150);
    CHECK(std::abs(wall - kHalf - robotX(world)) <= kGap);
  }
  SECTION("a ball between a robot and a wall") {
    config.balls.push_back({vsssPreset().ball, {0.70, 0.4}, {}, {}});
    World world = makeWorld(config);
    run(world, kForward, 150);
    const double ball = world.state().balls[0].position.x;
    CHECK(std::abs(wall - kBallRadius - ball) <= kGap);
    CHECK(std::abs(ball - robotX(world) - kHalf - kBallRadius) <= kGap);
  }
  SECTION("two robots") {
    config.robots.push_back({vsssPreset().robot, {{0.68, 0.4}, -math::kPi}, {}, 0.0});
    World world = makeWorld(config);
    run(world, kForward, 150);
    CHECK(std::abs(robotX(world, 1) - robotX(world, 0) - 2 * kHalf) <= kGap);
  }
  SECTION("a robot and a fixed disc") {
    config.obstacles.push_back(discAt({0.66, 0.4}));
    World world = makeWorld(config);
    run(world, kForward, 150);
    CHECK(std::abs(0.66 - 0.0335 - kHalf - robotX(world)) <= kGap);
  }
  SECTION("a robot and a fixed box") {
    config.obstacles.push_back(discAt({0.67, 0.4}));
    config.obstacles[0].shape = ObstacleShape::kBox;
    World world = makeWorld(config);
    run(world, kForward, 150);
    CHECK(std::abs(0.67 - 2 * kHalf - robotX(world)) <= kGap);
  }
  SECTION("two balls pressed together by a robot") {
    config.balls.push_back({vsssPreset().ball, {0.65, 0.4}, {}, {}});
    config.balls.push_back({vsssPreset().ball, {0.70, 0.4}, {}, {}});
    World world = makeWorld(config);
    run(world, kForward, 150);
    const auto& balls = world.state().balls;
    CHECK(std::abs(distance(balls[0].position, balls[1].position) - 2 * kBallRadius) <= kGap);
  }
}
