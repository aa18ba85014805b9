// Robots that drive into each other, the ball and the walls: what motors and floor do in a step is all that a step
// may gain.
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "engine/sim/drive.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/energy.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

/// The world's robots and their drives once more, to know what these do in the next step.
class Mirror {
 public:
  explicit Mirror(const WorldConfig& config) {
    for (const RobotPlacement& robot : config.robots)
      drives_.emplace_back(robot.model, config.physics.stepPeriod(), config.physics.wheel_command_step);
  }

  /// [J] that the drives add to the robots as they move now.
  double work(const World& world, const std::vector<WheelSpeeds>& commands) {
    double sum = 0.0;
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      const RobotState& robot = world.state().robots[i];
      const Vec2 ahead = math::unit(robot.pose.heading);
      drives_[i].setCommand(commands[i]);
      const BodyMotion change = drives_[i].step(
          {dot(ahead, robot.velocity), cross(ahead, robot.velocity), robot.angular_velocity});
      const Vec2 velocity = robot.velocity + ahead * change.forward + perp(ahead) * change.sideways;
      const RobotModel& model = world.config().robots[i].model;
      sum += energy(model, velocity, robot.angular_velocity + change.yaw) -
             energy(model, robot.velocity, robot.angular_velocity);
    }
    return sum;
  }

 private:
  std::vector<Drive> drives_;
};

/// Ball, walls and robots that hold the ball of a crowd: half of them chase it, the others drive at random.
std::vector<WheelSpeeds> crowd(const World& world, Rng& rng, std::vector<WheelSpeeds> commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (i % 2 == 0) commands[i] = chase(world.state().robots[i], world.state().balls[0].position);
    else if (rng.uniform(0.0, 1.0) < 0.03) commands[i] = {rng.uniform(-60.0, 60.0), rng.uniform(-60.0, 60.0)};
  }
  return commands;
}

}  // namespace

TEST_CASE("crowds that drive gain no more energy than their motors give", "[unit]") {
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset(), paperPreset());
  const int per_team = GENERATE(3, 5);
  CAPTURE(physics.name, preset.robot.name, per_team);
  double worst = 0.0;
  int touches = 0;
  for (std::uint64_t seed = 40; seed < 44; ++seed) {
    Rng rng(seed, kTestStream);
    World world = makeWorld(matchConfig(preset, readEachStep(physics), per_team, largeField()));
    Mirror mirror(world.config());
    std::vector<WheelSpeeds> commands(world.config().robots.size());
    double before = energy(world);
    for (int step = 0; step < 700; ++step) {
      commands = crowd(world, rng, commands);
      const double most = before + std::max(mirror.work(world, commands), -before);
      world.step(commands);
      const double now = energy(world);
      worst = std::max(worst, (now - most) / std::max(before, 0.01));
      touches += static_cast<int>(world.contacts().size());
      before = now;
    }
  }
  CHECK(worst <= 1e-4);
  CHECK(touches > 500);
}

TEST_CASE("a ball leaves a robot no faster than the robot's push and its bounce", "[unit]") {
  // One robot on a wide field, so that nothing squeezes the ball: along the normal it leaves the surface at most
  // with the restitution's share of the speed at which they met.
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  Rng rng(46, kTestStream);
  int hits = 0;
  double worst = -1.0;
  for (int shot = 0; shot < 150; ++shot) {
    WorldConfig config = loneRobot(preset.robot, readEachStep(physics));
    const double most_speed = preset.robot.maxSpeed();
    config.robots[0].pose.heading = rng.uniform(-math::kPi, math::kPi);
    config.robots[0].velocity = math::unit(config.robots[0].pose.heading) * rng.uniform(-most_speed, most_speed) / 2;
    config.robots[0].angular_velocity = rng.uniform(-3.0, 3.0);
    const Vec2 from = math::unit(rng.uniform(-math::kPi, math::kPi)) * 0.25;
    const Vec2 velocity = unitOr(Vec2{} - from, {}) * rng.uniform(1.0, 9.0);
    config.balls.push_back({preset.ball, from, velocity, velocity});
    World world = makeWorld(config);
    for (int step = 0; step < 60; ++step) {
      const RobotState robot = world.state().robots[0];
      const BallState ball = world.state().balls[0];
      run(world, {}, 1);
      if (world.contacts().empty()) continue;
      ++hits;
      const ContactEvent& event = world.contacts()[0];  // its normal points to the ball
      const auto leaving = [&](const RobotState& r, const BallState& b) {
        return dot(event.normal, b.velocity - r.velocity - perp(event.point - r.pose.position) * r.angular_velocity);
      };
      const double met = -leaving(robot, ball), left = leaving(world.state().robots[0], world.state().balls[0]);
      // What floor and motors change in a step, and how far the surface turns meanwhile, blurs both.
      worst = std::max(worst, left - preset.ball.robot_restitution * std::max(met, 0.0));
      break;
    }
  }
  CHECK(hits > 100);
  CHECK(worst < 0.5);
}
