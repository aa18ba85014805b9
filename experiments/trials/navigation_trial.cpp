#include "experiments/trials/navigation_trial.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/base/float_mode.hpp"
#include "navigation/methods/paths/tangent_graph_search.hpp"

namespace fulbito {
namespace {

constexpr double kLimitSpacing = 0.01;  // [m] between the points of the drawn L* path

WorldConfig worldOf(const TrialConfig& config) {
  WorldConfig world;
  world.field = config.field;
  world.physics = config.physics;
  world.robots.push_back({config.robot.robot, config.layout.start, {}, 0.0});
  world.obstacles = config.layout.obstacles;
  return world;
}

NavigationGoal goalOf(const Layout& layout) {
  return {layout.goal, layout.goal_heading, layout.goal_tolerance, layout.heading_tolerance, false};
}

/// The constant part of the scenes of a trial.
NavigationScene sceneOf(const TrialConfig& config) {
  NavigationScene scene;
  scene.dt = config.physics.controlPeriod();
  scene.field = &config.field;
  scene.robot = &config.robot.robot;
  scene.goal = goalOf(config.layout);
  return scene;
}

TrialRules rulesOf(const TrialConfig& config, double length_limit) {
  TrialRules rules;
  rules.length_limit = length_limit;
  rules.time_limit =
      timeBound(length_limit, config.robot.robot.maxSpeed(), config.robot.robot.wheel_acceleration);
  rules.forbidden = config.forbidden;
  return rules;
}

/// Checks the ranges of the options. Layouts, robots and profiles are checked when they are read.
Result<void> check(const TrialConfig& config) {
  const double speed = config.robot.robot.maxSpeed();
  if (!(speed >= 0.05 && speed <= 10.0)) {
    return fail(ErrorCode::kUsage, fmt::format("speed: {} is outside 0.05 ... 10 m/s", speed));
  }
  return validate(config.sensors);
}

}  // namespace

struct NavigationTrial::LimitPath {
  /// L*: the shortest path of the robot's centre among the obstacles at the start. It is the straight line if
  /// there is no such path, or if only moving obstacles block it.
  static LimitPath of(const TrialConfig& config);

  double length = 0.0;
  std::vector<Vec2> points;
};

NavigationTrial::LimitPath NavigationTrial::LimitPath::of(const TrialConfig& config) {
  const Layout& layout = config.layout;
  std::vector<DiscObstacle> discs;
  for (const ObstacleSpec& spec : layout.obstacles) {
    if (spec.motion == ObstacleMotion::kFixed) appendDiscs(spec, {spec.pose, {}}, discs);
  }
  std::vector<Circle> circles;
  circles.reserve(discs.size());
  for (const DiscObstacle& disc : discs)
    circles.push_back({disc.position, disc.radius + config.limit_clearance});
  TangentGraph graph;
  LimitPath limit;
  if (graph.search(layout.start.position, layout.goal, circles, &config.field,
                   config.robot.robot.width / 2)) {
    limit.length = graph.length();
    graph.sample(kLimitSpacing, limit.points);
  } else {
    limit.length = distance(layout.start.position, layout.goal);
    limit.points = {layout.start.position, layout.goal};
  }
  limit.length = std::max(limit.length, 1e-3);
  return limit;
}

NavigationTrial::NavigationTrial(const TrialConfig& config, World&& world, LimitPath&& limit)
    : config_(&config),
      world_(std::move(world)),
      limit_path_(std::move(limit.points)),
      referee_(config.layout, config.field, config.robot.robot, rulesOf(config, limit.length),
               config.physics.controlPeriod()),
      sensing_(config),
      scene_(sceneOf(config)) {
  if (config.sonars_only) sonars_.emplace(config);
  sensing_.observe(world_.state());
}

Result<NavigationTrial> NavigationTrial::create(const TrialConfig& config) {
  const FloatMode floats;
  if (auto checked = check(config); !checked) return tl::unexpected<Error>(checked.error());
  auto world = World::create(worldOf(config));
  if (!world) return tl::unexpected<Error>(world.error());
  return NavigationTrial(config, std::move(*world), LimitPath::of(config));
}

const NavigationScene& NavigationTrial::observe() {
  scene_.tick = world_.state().tick;
  scene_.self = sensing_.robot();
  scene_.obstacles = sensing_.obstacles();
  if (sonars_) sonars_->look(world_, scene_);
  return scene_;
}

bool NavigationTrial::step(WheelSpeeds wanted) {
  const FloatMode floats;
  command_ = roundedTo(wanted, config_->physics.wheel_command_step);
  world_.step({&command_, 1});
  sensing_.commanded(command_);
  sensing_.observe(world_.state());
  over_ = referee_.observe(world_.state(), world_.contacts(), command_);
  hash_.add(world_.state());
  return !over_;
}

double NavigationTrial::seconds() const {
  return static_cast<double>(world_.state().tick) * config_->physics.controlPeriod();
}

}  // namespace fulbito
