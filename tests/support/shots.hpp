#pragma once

#include "engine/core/math/random.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/worlds.hpp"

namespace fulbito::test {

/// What a ball is shot at.
enum class ShotTarget { kRobot, kTwoRobots, kRobotAtWall };

/// A ball shot along +x at resting robots around the origin, from anywhere behind, at any of their headings.
inline WorldConfig shotAt(ShotTarget target, const RobotPreset& preset, const PhysicsProfile& physics,
                          double speed, Rng& rng) {
  WorldConfig config{wideField(), readEachStep(physics), {}, {}, {}};
  const double half = preset.robot.width / 2;
  double aside = rng.uniform(-0.045, 0.045);
  if (target == ShotTarget::kRobot) {
    config.robots.push_back({preset.robot, {{}, rng.uniform(-math::kPi, math::kPi)}, {}, 0.0});
  } else if (target == ShotTarget::kTwoRobots) {
    const double gap = rng.uniform(0.0, 0.035);
    for (double side : {-1.0, 1.0}) {
      config.robots.push_back({preset.robot, {{0.0, side * (half + gap / 2)}, 0.0}, {}, 0.0});
    }
    aside = rng.uniform(-0.02, 0.02);
  } else {
    config.field.width = 2.0;
    config.robots.push_back({preset.robot, {{0.0, -1.0 + half}, 0.0}, {}, 0.0});
    aside = -1.0 + preset.ball.radius + rng.uniform(0.0, 0.03);
  }
  const Vec2 velocity = math::unit(target == ShotTarget::kRobot ? 0.0 : rng.uniform(-0.03, 0.03)) * speed;
  config.balls.push_back({preset.ball, {rng.uniform(-0.35, -0.15), aside}, velocity, velocity});
  return config;
}

/// Whether the ball's centre goes deep into a robot, between two steps too, and comes out in front.
inline bool passesThrough(const WorldConfig& config, double speed) {
  constexpr double kDeep = 0.022;  // [m] past the surface: the ball's centre is inside
  World world = makeWorld(config);
  Vec2 before = world.state().balls[0].position;
  bool deep = false;
  for (int step = 0; step < config.physics.control_rate / 4; ++step) {
    run(world, {}, 1);
    const Vec2 now = world.state().balls[0].position;
    for (const RobotState& robot : world.state().robots) {
      for (int k = 1; k <= 8; ++k) {
        const Vec2 between = before + (now - before) * (k / 8.0);
        deep |= depthOf(config.robots[0].model, robot.pose, between, config.balls[0].model.radius) > kDeep;
      }
    }
    before = now;
  }
  return deep && before.x > 0.06 && world.state().balls[0].velocity.x > 0.3 * speed;
}

}  // namespace fulbito::test
