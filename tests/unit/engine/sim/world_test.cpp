#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fulbito/detail/state_hash.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string errorOf(const WorldConfig& config) {
  const Result<World> world = World::create(config);
  return world ? "" : world.error().message;
}

std::uint64_t hashOf(const World& world) {
  StateHash hash;
  hash.add(world.state());
  return hash.value();
}

WorldConfig threeAside() { return matchConfig(vsssPreset(), standardPhysics(), 3, {}); }

bool allFinite(const WorldState& state) {
  for (const RobotState& robot : state.robots) {
    if (!isFinite(robot.pose.position) || !isFinite(robot.velocity)) return false;
    if (!std::isfinite(robot.pose.heading) || !std::isfinite(robot.wheels.left + robot.wheels.right))
      return false;
  }
  for (const BallState& ball : state.balls) {
    if (!isFinite(ball.position) || !isFinite(ball.velocity) || !isFinite(ball.spin)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a new world shows what it was made from", "[unit]") {
  WorldConfig config = threeAside();
  config.robots[4].pose = {{0.1, 0.2}, 0.5};
  config.robots[4].velocity = {0.3, -0.4};
  config.balls[0].velocity = {1.0, 0.5};
  config.balls[0].spin = {0.25, 0.125};
  config.obstacles.push_back(discAt({0.25, -0.25}));
  const World world = makeWorld(config);
  const WorldState& state = world.state();
  CHECK(state.tick == 0);
  REQUIRE(state.robots.size() == 6);
  CHECK(state.robots[4].pose.position.x == Approx(0.1));
  CHECK(state.robots[4].pose.position.y == Approx(0.2));
  CHECK(state.robots[4].pose.heading == Approx(0.5));
  CHECK(state.robots[4].velocity.x == Approx(0.3));
  CHECK(state.balls[0].velocity.x == Approx(1.0));
  CHECK(state.balls[0].spin == Vec2{0.25, 0.125});
  CHECK(state.obstacles[0].pose.position.x == Approx(0.25));
  CHECK(world.contacts().empty());
}

TEST_CASE("Box2D's profiling clock is out of the program", "[unit]") {
  World world = makeWorld(threeAside());
  run(world, {30.0, 20.0}, 300);
  CHECK(world.engineProfileMilliseconds() == 0.0f);
}

TEST_CASE("NaN, infinite and missing commands are harmless", "[unit]") {
  const WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  World reference = makeWorld(config), nan = makeWorld(config), infinite = makeWorld(config),
        limit = makeWorld(config), missing = makeWorld(config);
  for (int tick = 0; tick < 60; ++tick) {
    reference.step(std::vector{WheelSpeeds{}});
    nan.step(std::vector{WheelSpeeds{kNan, kNan}});
    missing.step({});
    infinite.step(std::vector{WheelSpeeds{kInfinity, kInfinity}});
    limit.step(std::vector{WheelSpeeds{46.08, 46.08}});
  }
  CHECK(hashOf(nan) == hashOf(reference));
  CHECK(hashOf(missing) == hashOf(reference));
  CHECK(hashOf(infinite) == hashOf(limit));
  CHECK(infinite.state().robots[0].velocity.x == Approx(1.198).epsilon(0.001));
}

TEST_CASE("commands are rounded to the profile's step", "[unit]") {
  const WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  World exact = makeWorld(config), rounded = makeWorld(config), other = makeWorld(config);
  run(exact, {10.0, 12.0}, 60);
  run(rounded, {10.0049, 11.9951}, 60);
  run(other, {10.01, 12.0}, 60);
  CHECK(hashOf(rounded) == hashOf(exact));
  CHECK(hashOf(other) != hashOf(exact));
}

TEST_CASE("a world moves with its robots' handles intact", "[unit]") {
  World first = makeWorld(threeAside());
  run(first, {20.0, 25.0}, 50);
  World second = std::move(first);
  World twin = makeWorld(threeAside());
  run(twin, {20.0, 25.0}, 50);
  run(second, {5.0, 9.0}, 50);
  run(twin, {5.0, 9.0}, 50);
  CHECK(hashOf(second) == hashOf(twin));
}

TEST_CASE("five a side, several balls and fifty obstacles stay finite and apart", "[unit]") {
  WorldConfig config = matchConfig(vsssPreset(), standardPhysics(), 5, largeField());
  for (int i = 0; i < 4; ++i)
    config.balls.push_back({vsssPreset().ball, {0.3 * i - 0.45, 0.7}, {2.0, 1.0}, {}});
  for (int i = 0; i < 50; ++i) {
    const Vec2 at{-0.9 + 0.2 * (i % 10), -0.7 + 0.35 * (i / 10)};
    ObstacleSpec disc = discAt(at, static_cast<ObstacleMotion>(i % 3));
    disc.path = {at, {at.x, at.y + 0.1}};
    disc.radius = 0.02;
    config.obstacles.push_back(disc);
  }
  World world = makeWorld(config);
  std::vector<WheelSpeeds> commands(10);
  for (int tick = 0; tick < 1200; ++tick) {
    for (std::size_t i = 0; i < 10; ++i)
      commands[i] = chase(world.state().robots[i], world.state().balls[i % 5].position);
    world.step(commands);
  }
  CHECK(allFinite(world.state()));
  for (const BallState& ball : world.state().balls) CHECK(insideField(config.field, ball.position, 0.0));
}

TEST_CASE("a robot that spins for minutes keeps its heading within range and precision", "[unit]") {
  World world = makeWorld(loneRobot(vsssPreset().robot, standardPhysics()));
  run(world, {-40.0, 40.0}, 60);
  const double rate = world.state().robots[0].angular_velocity;
  const double start = world.state().robots[0].pose.heading;
  const int ticks = 60 * 120;
  run(world, {-40.0, 40.0}, ticks);
  const double heading = world.state().robots[0].pose.heading;
  CHECK(heading >= -math::kPi);
  CHECK(heading < math::kPi);
  // 3300 rad of single-precision steps of 0.2 rad: each is good to 4e-6 when the angle stays below 50.
  CHECK(std::abs(math::wrapAngle(heading - start - rate * ticks / 60.0)) < 0.05);
}

TEST_CASE("half a turn of the field maps one team's second onto the other's within three millimetres",
          "[unit]") {
  // Not for the fast profile: when several bodies pile up, its steps show the order of contacts.
  const auto physics = GENERATE(standardPhysics(), faithfulPhysics());
  const bool at_the_ball = GENERATE(false, true);
  CAPTURE(physics.name, at_the_ball);
  World world = makeWorld(matchConfig(vsssPreset(), physics, 3, {}));
  std::vector<WheelSpeeds> commands(6);
  double worst = 0.0;
  for (int tick = 0; tick < 60; ++tick) {
    const WorldState& state = world.state();
    for (std::size_t i = 0; i < 3; ++i) {
      const double s = static_cast<double>(i);
      commands[i] = at_the_ball ? chase(state.robots[i], {}) : WheelSpeeds{30.0 - 4.0 * s, 26.0 + 3.0 * s};
      commands[i + 3] = commands[i];
    }
    world.step(commands);
    for (std::size_t i = 0; i < 3; ++i) {
      worst = std::max(worst, norm(state.robots[i].pose.position + state.robots[i + 3].pose.position));
    }
    worst = std::max(worst, norm(state.balls[0].position));
  }
  // By then, the crowd at the ball has met once more.
  const double most = physics.name == "faithful" ? 0.002 : at_the_ball ? 0.003 : 0.001;  // [m]
  CHECK(worst <= most);
}

TEST_CASE("a configuration that cannot be is refused by name", "[unit]") {
  WorldConfig config = threeAside();
  SECTION("a robot outside") {
    config.robots[2].pose.position = {0.8, 0.5};
    CHECK(errorOf(config) == "robot 2: position (0.8, 0.5) is outside the field");
  }
  SECTION("a robot nowhere") {
    config.robots[5].pose.heading = kNan;
    CHECK(errorOf(config) == "robot 5: heading must be -100 ... 100, not nan");
  }
  SECTION("a ball that is too fast") {
    config.balls[0].velocity = {80.0, 0.0};
    CHECK(errorOf(config) == "ball 0: velocity must be 0 ... 50, not 80");
  }
  SECTION("a ball without size") {
    config.balls[0].model.radius = 0.0;
    CHECK(errorOf(config) == "ball 0: radius must be 0.002 ... 0.5, not 0");
  }
  SECTION("an obstacle without a path") {
    config.obstacles.push_back(discAt({}, ObstacleMotion::kPath));
    CHECK(errorOf(config) == "obstacle 0: path needs at least 2 waypoints");
  }
  SECTION("an obstacle without mass") {
    config.obstacles = {discAt({}), discAt({}, ObstacleMotion::kPushable)};
    config.obstacles[1].mass = kInfinity;
    CHECK(errorOf(config) == "obstacle 1: mass must be 0.001 ... 100, not inf");
  }
  SECTION("no steps") {
    config.physics.substeps = 0;
    CHECK(errorOf(config) == "physics: substeps must be 1 ... 64, not 0");
  }
  SECTION("a field without size") {
    config.field.length = kNan;
    CHECK(errorOf(config) == "field: length must be 0.3 ... 20, not nan");
  }
}
