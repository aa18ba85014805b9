#include "bench/scenes.hpp"

#include "engine/core/base/assert.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/detail/state_hash.hpp"

namespace fulbito {
namespace {

constexpr double kWheelLimit = 46.0;  // [rad/s]

// Wheel speeds that drive forward or backward at the target, and never stop pushing.
WheelSpeeds chase(const Pose2& pose, Vec2 target) {
  const Vec2 ahead = math::unit(pose.heading), to = unitOr(target - pose.position, ahead);
  const double sense = dot(ahead, to) >= 0.0 ? 1.0 : -1.0;
  const double along = 35.0 * sense, turn = 20.0 * sense * cross(ahead, to);
  return {along - turn, along + turn};
}

RobotModel sceneRobot() {
  RobotModel robot;
  robot.name = "scene";
  robot.length = robot.width = 0.075;
  robot.mass = 0.15;
  robot.wheel_radius = 0.026;
  robot.axle_track = 0.0775;
  robot.max_wheel_speed = 46.08;
  robot.wheel_acceleration = robot.wheel_braking = 7.0;
  robot.longitudinal_grip = 9.0;
  robot.lateral_grip = 6.0;
  robot.friction = 0.2;
  robot.restitution = 0.1;
  return robot;
}

BallModel sceneBall() {
  BallModel ball;
  ball.radius = 0.0215;
  ball.mass = 0.056;
  ball.roll_keep = 0.69;
  ball.slide_deceleration = 3.0;
  ball.roll_deceleration = 0.14;
  ball.stop_speed = 0.01;
  ball.wall_restitution = 0.5;
  ball.wall_spin_keep = 0.306;
  ball.robot_restitution = 0.04;
  ball.friction = 0.1;
  return ball;
}

PhysicsProfile profile(int substeps) {
  PhysicsProfile physics;
  physics.name = "scene";
  physics.control_rate = 60;
  physics.substeps = substeps;
  physics.velocity_iterations = 12;
  physics.position_iterations = 3;
  physics.restitution_threshold = 0.1;
  physics.wheel_command_step = 0.01;
  return physics;
}

ObstacleSpec disc(Vec2 position, ObstacleMotion motion) {
  ObstacleSpec obstacle;
  obstacle.motion = motion;
  obstacle.pose.position = position;
  if (motion == ObstacleMotion::kPath) obstacle.path = {position, position + Vec2{0.1, 0.2}};
  return obstacle;
}

WorldConfig withObstacles(WorldConfig config) {
  int i = 0;
  for (double y : {-0.4, 0.0, 0.4}) {
    config.obstacles.push_back(disc({-0.15, y}, ObstacleMotion::kPushable));
    config.obstacles.push_back(disc({0.15, y}, static_cast<ObstacleMotion>(i++ % 3)));
  }
  config.obstacles[2].shape = ObstacleShape::kBox;
  return config;
}

WorldConfig ballShots() {
  WorldConfig config = matchScene(1, profile(2));
  for (int i = 1; i < 8; ++i) {
    const Vec2 velocity = math::unit(0.9 * i) * (0.7 * i);
    config.balls.push_back({sceneBall(), {-0.4 + 0.1 * i, 0.3}, velocity, velocity * 0.5});
  }
  return config;
}

void add(StateHash& hash, const ContactEvent& event) {
  for (BodyId id : {event.a, event.b}) {
    hash.add(static_cast<std::uint64_t>(id.kind));
    hash.add(std::uint64_t{id.index});
  }
  for (double value : {event.point.x, event.point.y, event.normal.x, event.normal.y, event.impulse})
    hash.add(value);
  hash.add(std::uint64_t{event.began});
}

}  // namespace

const char* nameOf(Load load) {
  switch (load) {
    case Load::kRandom:
      return "random";
    case Load::kHold:
      return "hold";
    case Load::kChase:
      break;
  }
  return "chase";
}

SceneDriver::SceneDriver(Load load, std::size_t robots, int control_rate, std::uint64_t seed)
    : load_(load),
      hold_ticks_(load == Load::kHold ? control_rate / 2 : 1),
      rng_(seed, Stream::kWheelCommands),
      commands_(robots),
      poses_(robots) {}

void SceneDriver::drawWheels() {
  // 16 bits per wheel are precise enough, and keep the time for random numbers out of the benchmark.
  constexpr double kScale = 2.0 * kWheelLimit / 65535.0;
  for (WheelSpeeds& wheels : commands_) {
    const std::uint32_t bits = rng_.bits32();
    wheels = {(bits & 0xffffu) * kScale - kWheelLimit, (bits >> 16) * kScale - kWheelLimit};
  }
}

std::span<const WheelSpeeds> SceneDriver::drive(std::span<const Pose2> robots, Vec2 target) {
  if (load_ == Load::kChase) {
    for (std::size_t i = 0; i < robots.size(); ++i) commands_[i] = chase(robots[i], target);
  } else if (ticks_ % hold_ticks_ == 0) {
    drawWheels();
  }
  ++ticks_;
  return commands_;
}

std::span<const WheelSpeeds> SceneDriver::drive(const WorldState& state) {
  for (std::size_t i = 0; i < poses_.size(); ++i) poses_[i] = state.robots[i].pose;
  return drive(poses_, state.balls.empty() ? Vec2{} : state.balls[0].position);
}

WorldConfig matchScene(int per_team, const PhysicsProfile& physics) {
  WorldConfig config;
  config.physics = physics;
  if (per_team > 3) {
    config.field.name = "vsss-5v5";
    config.field.length = 2.2;
    config.field.width = 1.8;
    config.field.goal_depth = 0.15;
  }
  for (int team = 0; team < 2; ++team) {
    const double side = team == 0 ? -1.0 : 1.0;
    for (int i = 0; i < per_team; ++i) {
      const double y = (i - (per_team - 1) / 2.0) * config.field.width / (per_team + 1);
      config.robots.push_back({sceneRobot(),
                               {{side * config.field.length / 4, -side * y}, team == 0 ? 0.0 : -math::kPi},
                               {},
                               0.0});
    }
  }
  config.balls.push_back({sceneBall(), {}, {}, {}});
  return config;
}

std::vector<Scene> fixedScenes() {
  return {
      {"3v3-random", matchScene(3, profile(2)), Load::kRandom, 1200},
      {"3v3-hold-fast", matchScene(3, profile(1)), Load::kHold, 1200},
      {"3v3-chase", matchScene(3, profile(2)), Load::kChase, 1200},
      {"3v3-chase-faithful", matchScene(3, profile(4)), Load::kChase, 600},
      {"ball-shots", ballShots(), Load::kHold, 600},
      {"obstacles", withObstacles(matchScene(3, profile(2))), Load::kHold, 1200},
      {"5v5-chase", matchScene(5, profile(2)), Load::kChase, 600},
  };
}

std::uint64_t hashOfRun(const Scene& scene) {
  Result<World> world = World::create(scene.config);
  FULBITO_DEMAND(world.has_value());
  SceneDriver driver(scene.load, scene.config.robots.size(), scene.config.physics.control_rate, 1);
  StateHash hash;
  for (int tick = 0; tick < scene.ticks; ++tick) {
    world->step(driver.drive(world->state()));
    hash.add(world->state());
    for (const ContactEvent& event : world->contacts()) add(hash, event);
  }
  return hash.value();
}

std::uint64_t sceneSignature() {
  StateHash hash;
  for (const Scene& scene : fixedScenes()) hash.add(hashOfRun(scene));
  return hash.value();
}

}  // namespace fulbito
