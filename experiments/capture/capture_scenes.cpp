#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/capture/capture_results.hpp"
#include "experiments/capture/hall.hpp"
#include "experiments/capture/paper_tables.hpp"
#include "fulbito/detail/math.hpp"
#include "navigation/geometry/arc.hpp"

namespace fulbito::capture {
namespace {

constexpr std::size_t kStride = 6;  // ticks between rows
constexpr double kMargin = 0.6;     // [m] around all that is shown

/// A body of a scene and its way.
struct Actor {
  std::string label;
  RobotModel model;
  const std::vector<Pose2>* trace;
};

/// Moves everything so that its middle is the origin, and sets a field around it.
void frame(ReportScene& scene) {
  Vec2 low{1e9, 1e9}, high{-1e9, -1e9};
  const auto widen = [&](Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  };
  for (const PageRow& row : scene.page.rows) {
    for (const Pose2& pose : row.poses) widen(pose.position);
  }
  for (const ScenePath& path : scene.paths) std::for_each(path.points.begin(), path.points.end(), widen);
  const Vec2 middle = (low + high) * 0.5;
  for (PageRow& row : scene.page.rows) {
    for (Pose2& pose : row.poses) pose.position -= middle;
  }
  for (ScenePath& path : scene.paths) {
    for (Vec2& point : path.points) point -= middle;
  }
  scene.page.field = hall();
  scene.page.field.length = high.x - low.x + 2 * kMargin;
  scene.page.field.width = high.y - low.y + 2 * kMargin;
}

void addActors(const std::vector<Actor>& actors, ReportScene& scene) {
  std::size_t ticks = 0;
  for (const Actor& actor : actors) {
    scene.labels.push_back(actor.label);
    scene.page.bodies.push_back({BodyKind::kRobot, {}, true, actor.model.length, actor.model.width, 0.0});
    ticks = std::max(ticks, actor.trace->size() - 1);
  }
  const auto row = [&](std::size_t tick) {
    PageRow at{static_cast<Tick>(tick), {}};
    for (const Actor& actor : actors)
      at.poses.push_back((*actor.trace)[std::min(tick, actor.trace->size() - 1)]);
    scene.page.rows.push_back(std::move(at));
  };
  for (std::size_t tick = 0; tick < ticks; tick += kStride) row(tick);
  row(ticks);
}

ReportScene sceneOf(std::string name, std::string title, std::string caption,
                    const std::vector<Actor>& actors, std::vector<ScenePath> paths) {
  ReportScene scene;
  scene.name = std::move(name);
  scene.caption = std::move(caption);
  scene.page.title = std::move(title);
  scene.page.rate = hallPhysics().control_rate;
  scene.paths = std::move(paths);
  addActors(actors, scene);
  frame(scene);
  finishScene(scene);
  return scene;
}

std::vector<Vec2> points(const Arc& arc, std::vector<Vec2> path) {
  constexpr int kPieces = 60;
  for (int i = 0; i <= kPieces; ++i) path.push_back(poseAt(arc, arc.length * i / kPieces).position);
  return path;
}

ReportScene curveScene(const CaptureResults& results) {
  constexpr std::size_t kSpeed = 4;  // 0.5 m/s
  const Pose2 start{{0.0, 0.0}, math::kPi / 2};
  const Arc single{start, -1 / PaperTables::kSingleRadius, PaperTables::kSingleRadius * PaperTables::kTurn};
  const Arc first{start, -1 / PaperTables::kDoubleRadius, PaperTables::kDoubleRadius * PaperTables::kTurn};
  const Arc second{endOf(first), 1 / PaperTables::kDoubleRadius,
                   PaperTables::kDoubleRadius * PaperTables::kTurn};
  return sceneOf(
      "fig-16", "Fig. 16: single and double curve at 0.5 m/s",
      "Both are set for the dashed curves. Slip makes every curve wider by the same length, which the "
      "double curve has twice. Each robot drives in a world of its own.",
      {{"single curve", results.robot, &results.curves.single[kSpeed].driven.trace},
       {"double curve", results.robot, &results.curves.both[kSpeed].driven.trace}},
      {{"single, without slip", points(single, {}), true},
       {"double, without slip", points(second, points(first, {})), true}});
}

ScenePath planPath(const CapturePlan& plan) {
  ScenePath path{"plan", {}, true};
  for (int i = 0; i * 0.25 < plan.motion.duration(); ++i) {
    path.points.push_back(plan.motion.at(i * 0.25).pose.position);
  }
  path.points.push_back(plan.motion.end().pose.position);
  return path;
}

ReportScene captureScene(const CaptureResults& results) {
  const PursuitResult& run = results.runs[kTracked].result;
  const PursuitResult& open = results.runs[kAsPlanned].result;
  return sceneOf(
      "fig-18", "Fig. 18: capture of a moving object",
      "The robot tracks the plan and allows for its slip. One whose wheels only turn as planned misses. "
      "The paper's gap is between the middles, so each body drives in a world of its own.",
      {{"robot", results.robot, &run.robot},
       {"object", objectModel(), &run.object},
       {"robot, wheels as planned", results.robot, &open.robot}},
      {planPath(run.driven)});
}

ReportScene freeScene(const CaptureResults& results) {
  const PursuitResult& run = results.runs[kFree].result;
  return sceneOf("fig-18-one-world", "Capture with both bodies in one world",
                 fmt::format("The robot ends {:.2f} m behind the object, which it must not touch on the way.",
                             results.settings.gap),
                 {{"robot", results.robot, &run.robot}, {"object", objectModel(), &run.object}},
                 {planPath(run.driven)});
}

}  // namespace

void addScenes(const CaptureResults& results, ExperimentReport& report) {
  report.scenes = {curveScene(results), captureScene(results), freeScene(results)};
  for (ReportScene& scene : report.scenes) scene.page.seed = results.seed;
}

}  // namespace fulbito::capture
