#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kLength = 0.6;  // [m] of the rod
constexpr double kMass = 0.4;    // [kg] of the rod

RobotModel strong() {
  RobotModel robot;
  robot.mass = 1.0;
  robot.wheel_acceleration = robot.wheel_braking = 1.0;
  return robot;
}

/// Two robots with a rod between them, the first at the left.
WorldConfig carrying(double heading = 0.0) {
  WorldConfig config;
  config.field = wideField();
  config.physics = standardPhysics();
  for (const double x : {-kLength / 2, kLength / 2}) {
    RobotPlacement robot;
    robot.model = strong();
    robot.pose = {{x, 0.0}, heading};
    config.robots.push_back(robot);
  }
  config.rods.push_back({0, 1, kLength, kMass});
  return config;
}

std::string errorOf(const WorldConfig& config) {
  const auto world = World::create(config);
  return world ? "" : world.error().message;
}

WheelSpeeds both(double speed) { return {speed / strong().wheel_radius, speed / strong().wheel_radius}; }

void drive(World& world, const std::vector<WheelSpeeds>& commands, int ticks) {
  for (int i = 0; i < ticks; ++i) world.step(commands);
}

double apart(const World& world) {
  return distance(world.state().robots[0].pose.position, world.state().robots[1].pose.position);
}

}  // namespace

TEST_CASE("a rod at rest pulls at nobody", "[unit]") {
  World world = makeWorld(carrying());
  drive(world, {}, 60);
  const RodState& rod = world.state().rods[0];
  CHECK(norm(rod.pose.position) < 1e-6);
  CHECK(norm(rod.forces[0]) < 1e-4);
  CHECK(norm(rod.forces[1]) < 1e-4);
}

TEST_CASE("a rod that speeds up takes its mass times the acceleration from both robots", "[unit]") {
  World world = makeWorld(carrying());
  // Both motors pull with full force until 0.5 m/s.
  const std::vector<WheelSpeeds> commands{both(0.5), both(0.5)};
  drive(world, commands, 12);
  const double before = world.state().rods[0].velocity.x;
  drive(world, commands, 1);
  const RodState& rod = world.state().rods[0];
  const double acceleration = (rod.velocity.x - before) * 60;
  // The motors' forces also move the rod.
  CHECK(acceleration == Approx(1.0 * 2.0 / (2.0 + kMass)).epsilon(0.02));
  CHECK(rod.forces[0].x + rod.forces[1].x == Approx(kMass * acceleration).epsilon(0.01));
  CHECK(rod.forces[0].y == Approx(0.0).margin(1e-3));
}

TEST_CASE("a robot draws the other one along by the rod", "[unit]") {
  World world = makeWorld(carrying());
  // One robot seeks a higher speed, the other a lower one: all motors pull with full force, 1 N per robot.
  drive(world, {both(0.2), both(0.4)}, 60);
  CHECK(apart(world) == Approx(kLength).margin(5e-4));
  const RodState& rod = world.state().rods[0];
  CHECK(rod.velocity.x > 0.2);
  CHECK(rod.velocity.x < 0.4);
  CHECK(rod.forces[1].x == Approx(1.0).margin(0.05));
  CHECK(rod.forces[0].x == Approx(-1.0).margin(0.05));
}

TEST_CASE("robots turn freely beneath the rod", "[unit]") {
  World world = makeWorld(carrying());
  drive(world, {{-5.0, 5.0}, {5.0, -5.0}}, 120);
  const RodState& rod = world.state().rods[0];
  CHECK(std::abs(world.state().robots[0].angular_velocity) > 2.0);
  CHECK(rod.angular_velocity == Approx(0.0).margin(1e-3));
  CHECK(norm(rod.forces[0]) < 0.02);
}

TEST_CASE("robots that drive past each other turn the rod; its length stays for minutes", "[unit]") {
  World world = makeWorld(carrying(math::kPi / 2));
  // Each robot drives on its circle about the rod's centre.
  const double inner = kLength / 2 - strong().axle_track / 2, outer = kLength / 2 + strong().axle_track / 2;
  const double turn = 0.5 / strong().wheel_radius;
  const std::vector<WheelSpeeds> commands{{-outer * turn, -inner * turn}, {inner * turn, outer * turn}};
  double worst = 0.0;
  for (int i = 0; i < 60 * 120; ++i) {
    drive(world, commands, 1);
    worst = std::max(worst, std::abs(apart(world) - kLength));
  }
  const RodState& rod = world.state().rods[0];
  CHECK(worst < 5e-4);
  CHECK(rod.angular_velocity == Approx(0.5).epsilon(0.02));
  // Joints and robots agree on where the rod is.
  const Vec2 half = math::unit(rod.pose.heading) * (kLength / 2);
  CHECK(distance(rod.pose.position + half, world.state().robots[1].pose.position) < 5e-4);
  CHECK(distance(rod.pose.position - half, world.state().robots[0].pose.position) < 5e-4);
}

TEST_CASE("worlds with a rod repeat bit for bit, and their hash knows the rod", "[unit]") {
  World one = makeWorld(carrying()), two = makeWorld(carrying());
  drive(one, {both(0.2), both(0.4)}, 100);
  drive(two, {both(0.2), both(0.4)}, 100);
  StateHash a, b, without;
  a.add(one.state());
  b.add(two.state());
  CHECK(a.value() == b.value());
  WorldState bare = one.state();
  bare.rods.clear();
  without.add(bare);
  CHECK(a.value() != without.value());
}

TEST_CASE("flawed rods are named", "[unit]") {
  WorldConfig config = carrying();
  config.rods[0].second = 2;
  CHECK(errorOf(config) == "rod 0: second must be the index of a robot");
  config.rods[0].second = 0;
  CHECK(errorOf(config) == "rod 0: second must be another robot than first");
  config.rods[0] = {0, 1, kLength, 0.0};
  CHECK(errorOf(config) == "rod 0: mass must be 0.001 ... 100, not 0");
  config.rods[0] = {0, 1, 0.7, kMass};
  CHECK_THAT(errorOf(config), Catch::StartsWith("rod 0: length must be 0.599 ... 0.601, not 0.7"));
  config.rods[0].length = std::nan("");
  CHECK_THAT(errorOf(config), Catch::StartsWith("rod 0: length must be"));
}
