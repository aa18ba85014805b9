#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

double forwardSpeed(const World& world) { return world.state().robots[0].velocity.x; }

// Time [s] from rest until the speed first passes `share` of the commanded rim speed, between two steps.
double riseTime(const RobotModel& robot, PhysicsProfile physics, double rim_speed, double share) {
  World world = makeWorld(loneRobot(robot, readEachStep(physics)));
  const double command = rim_speed / robot.wheel_radius, wanted = share * rim_speed;
  const double dt = world.config().physics.controlPeriod();
  double before = 0.0;
  for (int tick = 1; tick < 4000; ++tick) {
    run(world, {command, command}, 1);
    const double now = forwardSpeed(world);
    if (now >= wanted) return (tick - (now - wanted) / (now - before)) * dt;
    before = now;
  }
  return INFINITY;
}

struct Stop {
  double time;
  double distance;
};

Stop stopFrom(const RobotModel& robot, PhysicsProfile physics, double speed) {
  WorldConfig config = loneRobot(robot, readEachStep(physics));
  config.robots[0].velocity = {speed, 0.0};
  World world = makeWorld(config);
  const double dt = world.config().physics.controlPeriod();
  double before = speed;
  for (int tick = 1; tick < 4000; ++tick) {
    run(world, {}, 1);
    const double now = forwardSpeed(world);
    if (now < 1e-4) {
      // The last step needs only the part of the braking that is left.
      const double share = std::min(1.0, before / (robot.wheel_braking * dt));
      return {(tick - 1 + share) * dt, world.state().robots[0].pose.position.x};
    }
    before = now;
  }
  return {INFINITY, INFINITY};
}

double spinRate(const RobotModel& robot, const PhysicsProfile& physics, double wheels) {
  World world = makeWorld(loneRobot(robot, physics));
  run(world, {-wheels, wheels}, 240);
  return world.state().robots[0].angular_velocity;
}

double topSpeed(const RobotModel& robot, const PhysicsProfile& physics, double wheels) {
  World world = makeWorld(loneRobot(robot, physics));
  run(world, {wheels, wheels}, 100);
  return forwardSpeed(world);
}

}  // namespace

// The figures are from a simulator that acts 3 ms after a command: its recorded runs (recorded_driving_test)
// begin so. The figures imply 6.5 m/s2, and 7.5 m/s2 in braking; the runs imply 6.8 and 7.0.
TEST_CASE("the vsss robot speeds up as measured: 95 % of four speeds within 8 %", "[unit]") {
  constexpr double kDelay = 0.003;  // [s]
  const RobotModel robot = vsssPreset().robot;
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  const auto rise = [&](double speed) { return riseTime(robot, physics, speed, 0.95) + kDelay; };
  // 0.26 m/s is reached within two and a half steps of the fast profile, which is too coarse for 8 %.
  if (physics.name != "fast") CHECK(rise(0.26) == Approx(0.040).epsilon(0.08));
  CHECK(rise(0.52) == Approx(0.075).epsilon(0.08));
  CHECK(rise(1.04) == Approx(0.155).epsilon(0.08));
  CHECK(rise(1.198) == Approx(0.175).epsilon(0.08));
}

TEST_CASE("the firasim robot speeds up at 1.27 m/s2 and then holds its command", "[unit]") {
  const RobotModel robot = firasimPreset().robot;
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CHECK(riseTime(robot, physics, 0.8, 0.5) == Approx(0.4 / 1.27).epsilon(0.05));
  CHECK(topSpeed(robot, physics, 40.0) == Approx(0.8).epsilon(0.001));
}

TEST_CASE("braking takes the measured time and distance", "[unit]") {
  const auto physics = GENERATE(standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  const Stop vsss = stopFrom(vsssPreset().robot, physics, 1.0);
  CHECK(vsss.time == Approx(0.13).epsilon(0.10));
  CHECK(vsss.distance == Approx(0.067).epsilon(0.05));
  // From the recorded runs; the 0.084 m from 1 m/s of another measurement imply 0.054 m.
  const Stop firasim = stopFrom(firasimPreset().robot, physics, 0.8);
  CHECK(firasim.distance == Approx(0.041).epsilon(0.07));
}

TEST_CASE("the wheel speed limit gives the top speed", "[unit]") {
  CHECK(topSpeed(vsssPreset().robot, standardPhysics(), 1000.0) == Approx(1.20).epsilon(0.005));
  CHECK(topSpeed(paperPreset().robot, standardPhysics(), 1000.0) == Approx(2.6).epsilon(0.005));
}

TEST_CASE("spinning in place reaches the measured yaw rates", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CHECK(spinRate(vsssPreset().robot, physics, 20.0) == Approx(13.0).epsilon(0.01));
  CHECK(spinRate(vsssPreset().robot, physics, 40.0) == Approx(27.3).epsilon(0.01));
  CHECK(spinRate(firasimPreset().robot, physics, 20.0) == Approx(9.41).epsilon(0.01));
  CHECK(spinRate(firasimPreset().robot, physics, -40.0) == Approx(-21.3).epsilon(0.01));
}
