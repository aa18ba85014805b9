#include "experiments/papers/localization/run_scene.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "experiments/papers/localization/rig.hpp"

namespace fulbito::localization {
namespace {

constexpr std::size_t kMomentsPerRow = 4;  // 2.5 rows per second
constexpr double kGhostSize = 0.4;         // relative to the robot

/// Transforms from the frame that the robot chose to the world frame.
class WorldFrame {
 public:
  WorldFrame(const CleaningTask& task, bool turned)
      : room_{task.field.length, task.field.width}, turned_(turned) {}

  Pose2 pose(const Pose2& pose) const {
    const Pose2 seen = turned_ ? halfTurned(pose, room_) : pose;
    return {seen.position - Vec2{room_.x / 2, room_.y / 2}, seen.heading};
  }
  Vec2 point(Vec2 p) const { return pose({p, 0.0}).position; }

 private:
  Room room_;
  bool turned_;
};

/// Draws a line from each sensor with an echo to the wall's estimated place.
void drawEchoes(const CleaningMoment& moment, const Body& body, const WorldFrame& frame, Tick tick,
                std::vector<RecordedDrawing>& drawings) {
  for (const Beam beam : kBeams) {
    const auto& range = moment.ranges[indexOf(beam)];
    if (!range) continue;
    const Vec2 way = math::unit(moment.estimate.heading + directionOf(beam));
    const double reach = reachOf(body, beam);
    RecordedDrawing line;
    line.tick = tick;
    line.from = frame.point(moment.estimate.position + way * reach);
    line.to = frame.point(moment.estimate.position + way * (reach + *range));
    drawings.push_back(line);
  }
}

/// Draws the present part of the reference path, and a ring at the estimated pose.
void drawBelief(const CleaningMoment& moment, const CleaningResult& run, const Body& body,
                const WorldFrame& frame, Tick tick, std::vector<RecordedDrawing>& drawings) {
  RecordedDrawing part;
  part.tick = tick;
  part.from = frame.point(run.route[moment.part]);
  part.to = frame.point(run.route[moment.part + 1]);
  drawings.push_back(part);
  RecordedDrawing ring;
  ring.tick = tick;
  ring.kind = RecordedDrawing::Kind::kCircle;
  ring.from = frame.point(moment.estimate.position);
  ring.radius = norm({body.length / 2, body.width / 2});
  drawings.push_back(ring);
}

/// The robot's box, or a smaller one for its estimate.
PageBody boxOf(const RobotModel& robot, double size) {
  return {BodyKind::kRobot, {}, true, size * robot.length, size * robot.width, 0.0};
}

void addRows(const CleaningResult& run, const Body& body, const WorldFrame& frame, PageScene& page) {
  const double begin = run.moments.empty() ? 0.0 : run.moments.front().seconds;
  for (std::size_t i = 0; i < run.moments.size(); i += kMomentsPerRow) {
    const CleaningMoment& moment = run.moments[i];
    const auto tick = static_cast<Tick>(std::floor((moment.seconds - begin) * page.rate + 0.5));
    page.rows.push_back({tick, {frame.pose(moment.truth), frame.pose(moment.estimate)}});
    drawEchoes(moment, body, frame, tick, page.drawings);
    drawBelief(moment, run, body, frame, tick, page.drawings);
  }
}

}  // namespace

ReportScene runScene(const Ground& example, Scheme scheme, const std::string& name,
                     const std::string& title) {
  const CleaningTask& task = example.tasks.front();
  const CleaningResult& run = example.of(scheme).front();
  const WorldFrame frame(task, run.turned_frame);
  ReportScene scene;
  scene.name = name;
  scene.caption = fmt::format("Correction: {}. Largest deviation from the path {:.0f} mm.", nameOf(scheme),
                              1e3 * run.max_deviation);
  scene.labels = {"robot", "where it believes to be"};
  PageScene& page = scene.page;
  page.title = title;
  page.field = task.field;
  page.rate = kControlRate;
  page.drawing_ticks = kMomentsPerRow * kTicksPerPing;
  page.bodies = {boxOf(task.rover.robot, 1.0), boxOf(task.rover.robot, kGhostSize)};
  page.seed = task.seed;
  page.facts = {{"Correction", std::string(nameOf(scheme))}, {"Ring", "around the believed place"}};
  addRows(run, bodyOf(task.rover), frame, page);
  ScenePath path{"reference path", {}, true};
  for (const Vec2 point : run.route) path.points.push_back(frame.point(point));
  scene.paths.push_back(std::move(path));
  finishScene(scene);
  return scene;
}

}  // namespace fulbito::localization
