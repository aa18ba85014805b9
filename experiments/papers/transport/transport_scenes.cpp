#include <cmath>

#include <fmt/format.h>

#include "experiments/papers/transport/phases.hpp"
#include "experiments/papers/transport/transport_report.hpp"
#include "fulbito/models.hpp"

namespace fulbito {
namespace {

double inCm(double metres) { return metres * 100.0; }
double inMm(double metres) { return metres * 1000.0; }
double counted(std::size_t count) { return static_cast<double>(count); }

PageBody box(BodyKind kind, double length, double width) {
  PageBody body;
  body.kind = kind;
  body.box = true;
  body.length = length;
  body.width = width;
  return body;
}

constexpr double kRodWidth = 0.03;  // [m] drawn width

/// Colour indices of the roles, as in the paper's figures.
enum RoleColour : std::uint8_t { kMaster, kSlave, kRod };

/// The row of a scene at `time` [s].
std::size_t rowAt(const ReportScene& scene, double time) {
  const double ticks = time * scene.page.rate;
  std::size_t row = 0;
  while (row + 1 < scene.page.rows.size() && static_cast<double>(scene.page.rows[row + 1].tick) <= ticks)
    ++row;
  return row;
}

ReportScene sceneOf(const std::string& name, const TransportTask& task, const RodWorld& world,
                    double robot_length) {
  ReportScene scene;
  scene.name = name;
  scene.page.field = world.field;
  scene.page.bodies = {box(BodyKind::kRobot, robot_length, robot_length),
                       box(BodyKind::kRobot, robot_length, robot_length),
                       box(BodyKind::kObstacle, task.rod, kRodWidth)};
  scene.labels = {"leading robot", "following robot", "middle of the rod"};
  constexpr double kStride = 0.01;  // [m]
  scene.paths.push_back({"path", pointsAlong(task.path, kStride, world.centre), true});
  return scene;
}

Pose2 moved(Pose2 pose, Vec2 by) {
  pose.position += by;
  return pose;
}

Pose2 rodBetween(const Pose2& lead, const Pose2& follower) {
  return {(lead.position + follower.position) / 2, math::angleOf(lead.position - follower.position)};
}

}  // namespace

ReportScene planScene(const std::string& name, const std::string& title, const TransportTask& task,
                      const Carrying& work) {
  constexpr double kRate = 10.0;       // [Hz]
  constexpr Tick kEvery = 5;           // ticks between rows
  constexpr double kRobotShare = 0.2;  // drawn size relative to the rod; the robots are points
  const RodWorld world = rodWorldFor(task);
  ReportScene scene = sceneOf(name, task, world, kRobotShare * task.rod);
  scene.page.title =
      fmt::format("{}: {} parts, {} exchanges of roles", title, task.path.size(), work.switches.size());
  scene.caption =
      fmt::format("{:.1f} m of path in {:.0f} s; the rod has {:.0f} cm. Robots are points on the path.",
                  task.path.length(), work.seconds, inCm(task.rod));
  scene.page.rate = kRate;
  scene.roles.names = {"master", "slave", "rod"};
  scene.first_trail = scene.page.bodies.size();  // no trails, since the robots' trails are the path
  scene.outlines_every = -1.0;
  const double stride = static_cast<double>(kEvery) / kRate;
  const auto references = referencesOf(task, work, stride);
  for (std::size_t i = 0, row = 0; i < references.size(); ++i) {
    const RodReference& r = references[i];
    const Pose2 lead = moved(task.path.pose(r.lead.place.part, r.lead.place.q), -world.centre);
    const Pose2 follower = moved(task.path.pose(r.follower.place.part, r.follower.place.q), -world.centre);
    scene.page.rows.push_back({static_cast<Tick>(i) * kEvery, {lead, follower, rodBetween(lead, follower)}});
    while (row + 1 < work.rows.size() && work.rows[row + 1].time <= stride * counted(i)) ++row;
    const bool leads = work.rows[row].master == CarrierId::kLead;
    scene.roles.rows.push_back({leads ? kMaster : kSlave, leads ? kSlave : kMaster, kRod});
  }
  finishScene(scene);
  return scene;
}

void showSteps(const Carrying& work, ReportScene& scene) {
  for (const PaperStep& step : paperSteps(phasesOf(work), work.seconds))
    scene.moments.push_back({rowAt(scene, step.time), fmt::format("{}", step.number)});
  scene.caption +=
      " Steps 1 to 8 go the ways of Table 1 and Fig. 8, roles are ours; the last place is the end.";
}

void showEvery(double every, ReportScene& scene) {
  const double end = static_cast<double>(scene.page.ticks) / scene.page.rate;
  for (int i = 0; i * every < end; ++i)
    scene.moments.push_back({rowAt(scene, i * every), fmt::format("{}", i + 1)});
  scene.caption += fmt::format(" One place every {:g} s.", every);
}

ReportScene realScene(const std::string& name, const PathWork& work, const RealRun& run) {
  constexpr std::size_t kEvery = 12;  // ticks between rows
  ReportScene scene = sceneOf(name, work.task, work.world, work.world.robot.length);
  scene.page.title = fmt::format("A real rod at up to {:.0f} cm/s", inCm(run.pace));
  scene.caption = fmt::format(
      "The rod of 1 kg pulls with at most {:.2f} N; the robots stay within {:.1f} mm of the path.",
      run.drive.peak_force, inMm(run.drive.path_error));
  scene.page.rate = work.world.physics.control_rate;
  for (std::size_t i = 0; i < run.drive.frames.size(); i += kEvery) {
    const RodFrame& f = run.drive.frames[i];
    const Vec2 shift = -work.world.centre;
    scene.page.rows.push_back(
        {static_cast<Tick>(i), {moved(f.lead, shift), moved(f.follower, shift), moved(f.rod, shift)}});
  }
  finishScene(scene);
  return scene;
}

}  // namespace fulbito
