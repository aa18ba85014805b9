// Robots that drive into each other, the ball and the walls: a step may gain no more energy than motors and
// floor add.
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "engine/sim/drive.hpp"
#include "engine/sim/lasting_push.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/energy.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

BodyMotion inFrame(Vec2 ahead, Vec2 velocity, double yaw) {
  return {dot(ahead, velocity), cross(ahead, velocity), yaw};
}

/// Copies of the world's robots, their drives and the pushes that these expect, to predict the drives' work
/// in the next step.
class Mirror {
 public:
  explicit Mirror(const WorldConfig& config) {
    for (const RobotPlacement& robot : config.robots)
      robots_.push_back({Drive(robot.model, config.physics.stepPeriod(), config.physics.wheel_command_step)});
  }

  /// [J] that the drives add to the robots as they move now.
  double work(const World& world, const std::vector<WheelSpeeds>& commands) {
    double sum = 0.0;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      Robot& mirrored = robots_[i];
      const RobotState& robot = world.state().robots[i];
      const Vec2 ahead = math::unit(robot.pose.heading);
      mirrored.drive.setCommand(commands[i]);
      const BodyMotion change = mirrored.drive.step(inFrame(ahead, robot.velocity, robot.angular_velocity),
                                                    mirrored.push.expected());
      mirrored.velocity = robot.velocity + ahead * change.forward + perp(ahead) * change.sideways;
      mirrored.yaw = robot.angular_velocity + change.yaw;
      const RobotModel& model = world.config().robots[i].model;
      sum += energy(model, mirrored.velocity, mirrored.yaw) -
             energy(model, robot.velocity, robot.angular_velocity);
    }
    return sum;
  }

  /// Call after the step.
  void look(const World& world) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      Robot& mirrored = robots_[i];
      const RobotState& robot = world.state().robots[i];
      const Vec2 ahead = math::unit(robot.pose.heading);
      const BodyMotion after = inFrame(ahead, robot.velocity, robot.angular_velocity);
      // A robot that touches nothing was not pushed: a rounding error of the mirror must not stay as a push.
      const bool touches = std::ranges::any_of(world.contacts(), [&](const ContactEvent& contact) {
        const BodyId self{BodyKind::kRobot, static_cast<std::uint16_t>(i)};
        return contact.a == self || contact.b == self;
      });
      mirrored.push.measure(touches ? inFrame(ahead, mirrored.velocity, mirrored.yaw) : after, after);
    }
  }

 private:
  struct Robot {
    Drive drive;
    LastingPush push{};
    Vec2 velocity{};   // after motors and tyres
    double yaw = 0.0;  // the same
  };
  std::vector<Robot> robots_;
};

/// Commands for a crowd around the ball: half of the robots chase it, the others drive at random.
std::vector<WheelSpeeds> crowd(const World& world, Rng& rng, std::vector<WheelSpeeds> commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (i % 2 == 0)
      commands[i] = chase(world.state().robots[i], world.state().balls[0].position);
    else if (rng.uniform(0.0, 1.0) < 0.03)
      commands[i] = {rng.uniform(-60.0, 60.0), rng.uniform(-60.0, 60.0)};
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
      mirror.look(world);
      const double now = energy(world);
      worst = std::max(worst, (now - most) / std::max(before, 0.01));
      touches += static_cast<int>(world.contacts().size());
      before = now;
    }
  }
  CHECK(worst <= 1e-4);
  CHECK(touches > 500);
}

namespace {

/// One to three robots that drive at a ball in the open from all sides.
WorldConfig closingIn(const RobotPreset& preset, const PhysicsProfile& physics, int robots, Rng& rng) {
  WorldConfig config{wideField(), readEachStep(physics), {}, {}, {}};
  for (int i = 0; i < robots; ++i) {
    const Vec2 from = math::unit(2 * math::kPi * i / robots + rng.uniform(-0.5, 0.5));
    const double heading = math::atan2(-from.y, -from.x) + rng.uniform(-0.4, 0.4);
    const Vec2 velocity = math::unit(heading) * rng.uniform(0.0, preset.robot.maxSpeed());
    config.robots.push_back({preset.robot,
                             {from * (rng.uniform(0.08, 0.25) + 0.11 * i), heading},
                             velocity,
                             rng.uniform(-5.0, 5.0)});
  }
  const Vec2 course = math::unit(rng.uniform(-math::kPi, math::kPi));
  const Vec2 velocity = course * rng.uniform(0.0, 6.0);
  config.balls.push_back({preset.ball, {}, velocity, velocity});
  return config;
}

}  // namespace

TEST_CASE("one contact gives a ball at most the surface's speed and the bounce from it", "[unit]") {
  // Two robots that close on a ball squeeze it out faster than they are, which no single contact does.
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  const auto preset = GENERATE(vsssPreset(), firasimPreset());
  CAPTURE(physics.name, preset.robot.name);
  Rng rng(46, kTestStream);
  int touches = 0;
  double worst = -1.0;
  for (int scene = 0; scene < 300; ++scene) {
    World world = makeWorld(closingIn(preset, physics, 1 + scene % 3, rng));
    std::vector<WheelSpeeds> onward;
    for (const RobotState& robot : world.state().robots) onward.push_back(robot.wheels);
    for (int step = 0; step < 40; ++step) {
      const double speed = norm(world.state().balls[0].velocity), surface = fastestSurface(world);
      world.step(onward);
      const auto of_ball = [](const ContactEvent& e) { return e.b.kind == BodyKind::kBall; };
      if (std::count_if(world.contacts().begin(), world.contacts().end(), of_ball) != 1) continue;
      ++touches;
      // The ball keeps its speed across the contact. Along it, the ball leaves the surface with the bounce.
      const double along = surface + preset.ball.robot_restitution * (speed + surface);
      worst =
          std::max(worst, norm(world.state().balls[0].velocity) - std::sqrt(speed * speed + along * along));
    }
  }
  CHECK(touches > 300);
  CHECK(worst <= 0.03);
}
