#include <cmath>

#include "engine/core/models/shapes.hpp"
#include "fulbito/sensors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kDegree = math::kPi / 180.0;

SonarModel ring() {
  SonarModel model;
  for (double bearing : {90.0, 50.0, 30.0, 10.0, -10.0, -30.0, -50.0, -90.0}) {
    SonarSpec sonar;
    sonar.mount = {math::unit(bearing * kDegree) * 0.03, bearing * kDegree};
    model.sonars.push_back(sonar);
  }
  return model;
}

SonarModel single() {
  SonarModel model;
  model.sonars.resize(1);
  return model;
}

Rng stream(std::uint64_t index = 0) { return {7, Stream::kSonar, index}; }

WorldConfig facingDisc(double range) {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.obstacles.push_back(discAt({range + discAt({}).radius, 0.0}));
  return config;
}

}  // namespace

TEST_CASE("rays in a world end at its walls, balls, obstacles and other robots", "[unit]") {
  WorldConfig config = facingDisc(0.4);
  config.field.length = config.field.width = 4.0;
  config.balls.push_back({vsssPreset().ball, {0.0, 0.5}, {}, {}});
  config.robots.push_back({vsssPreset().robot, {{-0.6, 0.0}, 0.0}, {}, 0.0});
  const World world = makeWorld(config);
  CHECK(castRay(world, {}, {1.0, 0.0}, 5.0, 0).distance == Approx(0.4).margin(1e-6));
  CHECK(castRay(world, {}, {0.0, 1.0}, 5.0, 0).distance == Approx(0.5 - vsssPreset().ball.radius));
  CHECK(castRay(world, {}, {-1.0, 0.0}, 5.0, 0).distance == Approx(0.5625).margin(1e-6));
  CHECK(castRay(world, {}, {0.0, -1.0}, 5.0, 0).distance == Approx(2.0));
  // The robot's own body counts unless it is left out.
  CHECK(castRay(world, {0.1, 0.0}, {-1.0, 0.0}, 5.0).distance == Approx(0.0625).margin(1e-6));
}

TEST_CASE("sonars measure from their mounts along their axes", "[unit]") {
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.field.length = 1.2;
  config.field.width = 1.0;
  config.robots[0].pose = {{0.1, 0.05}, math::kPi / 2};
  const World world = makeWorld(config);
  SonarArray sonars(config.field, ring(), stream());
  const auto readings = sonars.measure(world, 0);
  CHECK(readings[0].range == Approx(0.7 - 0.03).margin(1e-6));  // left sonar: the wall at x = -0.6
  CHECK(readings[7].range == Approx(0.5 - 0.03).margin(1e-6));
  // 10 degrees from the normal of the wall ahead, which is inside the cone.
  CHECK(readings[3].range == Approx(0.45 - 0.03 * std::cos(10 * kDegree)).margin(1e-6));
  CHECK(sonars.echoes()[3].point.y == Approx(0.5).margin(1e-6));
}

TEST_CASE("without an echo a sonar reports its greatest range; a near echo its least", "[unit]") {
  WorldConfig config = facingDisc(0.4);
  SonarModel model = single();
  model.sonars[0].greatest = 0.3;
  const World world = makeWorld(config);
  const SonarReading silent = SonarArray(config.field, model, stream()).measure(world, 0)[0];
  CHECK_FALSE(silent.heard);
  CHECK(silent.range == 0.3);
  model.sonars[0].greatest = 0.9;
  model.sonars[0].least = 0.5;
  const SonarReading near = SonarArray(config.field, model, stream()).measure(world, 0)[0];
  CHECK(near.heard);
  CHECK(near.range == 0.5);
}

TEST_CASE("noise has the model's mean and deviation, drop-outs its rate", "[unit]") {
  const WorldConfig config = facingDisc(0.4);
  const World world = makeWorld(config);
  SonarModel model = single();
  model.noise = 0.005;
  model.dropout = 0.1;
  SonarArray sonar(config.field, model, stream());
  constexpr int kCount = 20'000;
  double sum = 0.0, squares = 0.0;
  int heard = 0;
  for (int i = 0; i < kCount; ++i) {
    const SonarReading reading = sonar.measure(world, 0)[0];
    if (!reading.heard) continue;
    ++heard;
    sum += reading.range - 0.4;
    squares += (reading.range - 0.4) * (reading.range - 0.4);
  }
  CHECK(heard / double{kCount} == Approx(0.9).margin(0.0085));  // 4 sigma
  CHECK(sum / heard == Approx(0.0).margin(0.00015));
  CHECK(std::sqrt(squares / heard) == Approx(0.005).epsilon(0.022));
}

TEST_CASE("readings repeat with their stream, and differ from trial to trial", "[unit]") {
  WorldConfig config = facingDisc(0.4);
  config.field = {};
  SonarModel model = ring();
  model.noise = 0.005;
  model.dropout = 0.05;
  model.cross_talk = 0.1;
  const auto drive = [&](std::uint64_t index) {
    World world = makeWorld(config);
    SonarArray sonars(config.field, model, stream(index));
    std::vector<double> ranges;
    for (int i = 0; i < 200; ++i) {
      for (const SonarReading& reading : sonars.measure(world, 0)) ranges.push_back(reading.range);
      run(world, {5.0, 9.0}, 1);
    }
    return ranges;
  };
  CHECK(drive(3) == drive(3));
  CHECK(drive(3) != drive(4));
}

TEST_CASE("with cross-talk a sonar takes its neighbour's earlier echo for its own", "[unit]") {
  WorldConfig config = facingDisc(0.4);
  SonarModel model;
  model.sonars.resize(2);
  // this sonar points aside and hears no echo of its own
  model.sonars[1].mount = {{0.0, 0.03}, math::kPi / 2};
  const World world = makeWorld(config);
  CHECK_FALSE(SonarArray(config.field, model, stream()).measure(world, 0)[1].heard);
  model.cross_talk = 1.0;
  const SonarReading stray = SonarArray(config.field, model, stream()).measure(world, 0)[1];
  CHECK(stray.heard);
  CHECK(stray.range == Approx((0.4 + norm(Vec2{0.4, 0.03})) / 2).margin(1e-6));
}

TEST_CASE("sonars see the walls where contacts happen", "[unit]") {
  // A robot touches the wall: its front sonar reads 0.
  WorldConfig config = loneRobot(vsssPreset().robot, standardPhysics());
  config.field.length = 0.6;
  config.field.width = 0.6;
  World world = makeWorld(config);
  SonarModel model = single();
  model.sonars[0].mount.position.x = vsssPreset().robot.length / 2;
  run(world, {20.0, 20.0}, 120);
  SonarArray sonar(config.field, model, stream());
  CHECK(sonar.measure(world, 0)[0].range == Approx(0.0).margin(0.001));
}
