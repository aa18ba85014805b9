#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/float_mode.hpp"
#include "experiments/trials/sensing.hpp"
#include "experiments/trials/trial_recorder.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/world.hpp"
#include "navigation/methods/paths/tangent_graph_search.hpp"
#include "referee/trial/trial_referee.hpp"

namespace fulbito {
namespace {

constexpr double kLimitSpacing = 0.01;  // [m] between the points of the drawn L* path

struct LimitPath {
  double length = 0.0;
  std::vector<Vec2> points;
};

/// L*: the shortest path of the robot's centre among the obstacles at the start. It is the straight line if
/// there is no such path, or if only moving obstacles block it.
LimitPath limitPath(const TrialConfig& config) {
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

/// Returns the result of `work` and, with a clock, appends its duration [us] to `durations`.
template <typename Work>
auto timed(const Clock& now, std::vector<double>& durations, const Work& work) {
  if (!now) return work();
  const std::int64_t begin = now();
  auto value = work();
  durations.push_back(static_cast<double>(now() - begin) * 1e-3);
  return value;
}

void addTouches(std::span<const ContactEvent> contacts, Tick tick, double dt, std::vector<Touch>& touches) {
  const auto solid = [](BodyId id) { return id.kind == BodyKind::kObstacle || id.kind == BodyKind::kWall; };
  const BodyId robot{BodyKind::kRobot, 0};
  for (const ContactEvent& event : contacts) {
    const bool its_own = (event.a == robot && solid(event.b)) || (event.b == robot && solid(event.a));
    if (event.began && its_own) touches.push_back({static_cast<double>(tick) * dt, event.point});
  }
}

}  // namespace

void appendDiscs(const ObstacleSpec& spec, const ObstacleState& state, std::vector<DiscObstacle>& discs) {
  if (spec.shape == ObstacleShape::kDisc) {
    discs.push_back({state.pose.position, spec.radius, state.velocity});
    return;
  }
  const bool lengthwise = spec.length >= spec.width;
  const double longer = std::max(spec.length, spec.width), shorter = std::min(spec.length, spec.width);
  const Vec2 x = math::unit(state.pose.heading);
  const Vec2 axis = lengthwise ? x : perp(x);
  const int count = std::max(1, static_cast<int>(std::ceil(longer / shorter - 1e-9)));
  const double part = longer / count;
  const double radius = 0.5 * std::sqrt(part * part + shorter * shorter);
  for (int i = 0; i < count; ++i) {
    discs.push_back({state.pose.position + axis * ((i + 0.5) * part - longer / 2), radius, state.velocity});
  }
}

Result<TrialResult> runTrial(const TrialConfig& config, const Clock& clock, TrialRecorder* recorder) {
  const FloatMode floats;
  if (auto checked = check(config); !checked) return tl::unexpected<Error>(checked.error());
  auto world = World::create(worldOf(config));
  if (!world) return tl::unexpected<Error>(world.error());
  auto pilot = makePilot(config.navigator);
  if (!pilot) return tl::unexpected<Error>(pilot.error());
  const LimitPath limit = limitPath(config);
  const double dt = config.physics.controlPeriod();
  TrialReferee referee(config.layout, config.field, config.robot.robot, rulesOf(config, limit.length), dt);

  TrialResult result;
  result.limit_path = limit.points;
  Sensing sensing(config);
  std::optional<SonarSight> sonars;
  if (config.sonars_only) sonars.emplace(config);
  StateHash hash;
  NavigationScene scene = sceneOf(config);
  (*pilot)->reset();
  sensing.observe(world->state());
  if (recorder != nullptr) recorder->begins(world->state());
  result.trace.push_back({0.0, world->state().robots.front(), {}});
  for (bool over = false; !over;) {
    scene.tick = world->state().tick;
    scene.self = sensing.robot();
    scene.obstacles = sensing.obstacles();
    if (sonars) sonars->look(*world, scene);
    const WheelSpeeds wanted = timed(clock, result.compute_us, [&] { return (*pilot)->drive(scene); });
    if (recorder != nullptr) {
      recorder->planned((*pilot)->guidance(), scene.self.pose.position, scene.goal.position);
    }
    const WheelSpeeds command = roundedTo(wanted, config.physics.wheel_command_step);
    world->step({&command, 1});
    sensing.commanded(command);
    sensing.observe(world->state());
    over = referee.observe(world->state(), world->contacts(), command);
    addTouches(world->contacts(), world->state().tick, dt, result.touches);
    hash.add(world->state());
    if (recorder != nullptr) recorder->ticked(world->state(), command, hash.value());
    result.trace.push_back(
        {static_cast<double>(world->state().tick) * dt, world->state().robots.front(), command});
  }
  result.score = referee.score();
  result.final_hash = hash.value();
  if (recorder != nullptr) {
    if (auto written = recorder->ends(result); !written) return tl::unexpected<Error>(written.error());
  }
  return result;
}

}  // namespace fulbito
