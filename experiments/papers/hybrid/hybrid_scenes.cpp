#include "experiments/papers/hybrid/hybrid_scenes.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fulbito/models.hpp"
#include "fulbito/world.hpp"

namespace fulbito::hybrid {
namespace {

constexpr Tick kMostTicks = 60 * 25;
constexpr Tick kRowTicks = 2;        // ticks between rows: 30 Hz
constexpr Tick kDrawingTicks = 6;    // ticks between drawn cones
constexpr double kShownRoom = 0.15;  // [m] from an obstacle, where the picture shows the cones

/// One robot's way, tick by tick, and what its sonars heard.
struct Drive {
  std::vector<Pose2> poses;
  std::vector<std::vector<RangeReading>> readings;
};

Result<Drive> drive(const TrialConfig& config) {
  WorldConfig setup;
  setup.field = config.field;
  setup.physics = config.physics;
  setup.robots.push_back({config.robot.robot, config.layout.start, {}, 0.0});
  setup.obstacles = config.layout.obstacles;
  auto world = World::create(setup);
  if (!world) return tl::unexpected<Error>(world.error());
  auto pilot = makePilot(config.navigator);
  if (!pilot) return tl::unexpected<Error>(pilot.error());
  SonarSight sight(config);
  NavigationScene scene;
  scene.dt = config.physics.controlPeriod();
  scene.robot = &config.robot.robot;
  scene.goal = {config.layout.goal, {}, config.layout.goal_tolerance, config.layout.heading_tolerance, false};
  Drive result;
  (*pilot)->reset();
  for (bool arrived = false; !arrived && world->state().tick < kMostTicks;) {
    scene.tick = world->state().tick;
    scene.self = world->state().robots.front();
    sight.look(*world, scene);
    result.poses.push_back(scene.self.pose);
    result.readings.emplace_back(scene.ranges.begin(), scene.ranges.end());
    const WheelSpeeds command = (*pilot)->drive(scene);
    world->step({&command, 1});
    arrived = distance(world->state().robots.front().pose.position, config.layout.goal) <
              config.layout.goal_tolerance;
  }
  return result;
}

/// A sonar's cone up to what it hears: both edges and the line between their ends.
void drawCone(const RangeReading& reading, const Pose2& pose, Tick tick,
              std::vector<RecordedDrawing>& drawings) {
  const Vec2 ahead = math::unit(pose.heading);
  const Vec2 apex = pose.position + outOfFrame(ahead, reading.mount.position);
  const auto edge = [&](double side) {
    return apex + math::unit(pose.heading + reading.mount.heading + side * reading.half_cone) * reading.range;
  };
  RecordedDrawing line;
  line.tick = tick;
  for (const auto& [from, to] :
       {std::pair{apex, edge(1.0)}, std::pair{edge(1.0), edge(-1.0)}, std::pair{edge(-1.0), apex}}) {
    line.from = from, line.to = to;
    drawings.push_back(line);
  }
}

void addBodies(const TrialConfig& config, std::size_t robots, PageScene& page) {
  const RobotModel& robot = config.robot.robot;
  page.bodies.assign(robots, {BodyKind::kRobot, {}, true, robot.length, robot.width, 0.0});
  for (const ObstacleSpec& spec : config.layout.obstacles)
    page.bodies.push_back({BodyKind::kObstacle, {}, false, 0.0, 0.0, spec.radius});
}

void addRows(const TrialConfig& config, const std::vector<Drive>& drives, PageScene& page) {
  std::size_t ticks = 0;
  for (const Drive& way : drives) ticks = std::max(ticks, way.poses.size());
  for (std::size_t tick = 0; tick < ticks; tick += static_cast<std::size_t>(kRowTicks)) {
    PageRow row{static_cast<Tick>(tick), {}};
    for (const Drive& way : drives) row.poses.push_back(way.poses[std::min(tick, way.poses.size() - 1)]);
    for (const ObstacleSpec& spec : config.layout.obstacles) row.poses.push_back(spec.pose);
    page.rows.push_back(std::move(row));
  }
}

void addCones(const Drive& way, PageScene& page) {
  page.drawing_ticks = kDrawingTicks;
  for (std::size_t tick = 0; tick < way.poses.size(); tick += static_cast<std::size_t>(kDrawingTicks)) {
    for (const RangeReading& reading : way.readings[tick]) {
      if (reading.heard) drawCone(reading, way.poses[tick], static_cast<Tick>(tick), page.drawings);
    }
  }
}

/// The first row in which the first body is within `room` [m] of an obstacle's rim; the last one if it never
/// is.
std::size_t firstRowNear(const PageScene& page, double room) {
  for (std::size_t row = 0; row < page.rows.size(); ++row) {
    const std::vector<Pose2>& poses = page.rows[row].poses;
    for (std::size_t i = 1; i < page.bodies.size(); ++i) {
      if (page.bodies[i].kind != BodyKind::kObstacle) continue;
      if (distance(poses[0].position, poses[i].position) - page.bodies[i].radius < room) return row;
    }
  }
  return page.rows.size() - 1;
}

}  // namespace

Result<ReportScene> hybridScene(const std::string& name, const std::string& title, const Layout& layout,
                                double speed, std::uint64_t seed, std::uint64_t index, bool with_rival) {
  std::vector<Drive> drives;
  TrialConfig shown;
  for (bool with_diagram : {true, false}) {
    if (!with_diagram && !with_rival) break;
    const auto config = hybridTrial(layout, Knowledge::kSonars, with_diagram, speed, seed, index);
    if (!config) return tl::unexpected<Error>(config.error());
    auto way = drive(*config);
    if (!way) return tl::unexpected<Error>(way.error());
    drives.push_back(std::move(*way));
    if (with_diagram) shown = *config;
  }
  ReportScene scene;
  scene.name = name;
  scene.caption =
      fmt::format("The cones show what the sonars of the first robot hear {:.0f} mm from the next obstacle.",
                  1e3 * kShownRoom);
  scene.labels = {"hybrid"};
  if (with_rival) scene.labels.emplace_back("hybrid-without-nd");
  scene.page.title = title;
  scene.page.field = shown.field;
  scene.page.rate = shown.physics.control_rate;
  scene.page.seed = seed;
  scene.page.task = PageTask{layout.start, layout.goal, layout.goal_tolerance, {}};
  addBodies(shown, drives.size(), scene.page);
  addRows(shown, drives, scene.page);
  addCones(drives.front(), scene.page);
  scene.moments = {{firstRowNear(scene.page, kShownRoom), ""}};
  finishScene(scene);
  return scene;
}

}  // namespace fulbito::hybrid
