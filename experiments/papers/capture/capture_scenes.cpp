#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/papers/capture/capture_results.hpp"
#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/capture/hall.hpp"
#include "experiments/papers/capture/paper_tables.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr std::size_t kStride = 6;  // ticks between rows
constexpr double kMargin = 0.6;     // [m] around everything shown
constexpr double kPoint = 0.045;    // [m] radius of a body that is drawn as a point

/// A body of a scene and its trace.
struct Actor {
  std::string label;
  RobotModel model;
  const std::vector<Pose2>* trace;
};

/// How bodies are shown.
enum class Shown : std::uint8_t { kOutlines, kPoints };

/// Moves everything so that its centre is the origin, and sets a field around it.
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
  for (RecordedDrawing& drawing : scene.page.drawings) drawing.from -= middle;
  scene.page.field = hall();
  scene.page.field.length = high.x - low.x + 2 * kMargin;
  scene.page.field.width = high.y - low.y + 2 * kMargin;
}

PageBody bodyOf(const RobotModel& model, Shown shown) {
  if (shown == Shown::kPoints) return {BodyKind::kRobot, {}, false, 0.0, 0.0, kPoint};
  return {BodyKind::kRobot, {}, true, model.length, model.width, 0.0};
}

/// Adds bodies until the trace of the first one ends or, with `all`, that of the last one.
void addActors(const std::vector<Actor>& actors, Shown shown, bool all, ReportScene& scene) {
  std::size_t ticks = actors.front().trace->size() - 1;
  for (const Actor& actor : actors) {
    scene.labels.push_back(actor.label);
    scene.page.bodies.push_back(bodyOf(actor.model, shown));
    if (all) ticks = std::max(ticks, actor.trace->size() - 1);
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

ReportScene emptyScene(std::string name, std::string title, std::string caption) {
  ReportScene scene;
  scene.name = std::move(name);
  scene.caption = std::move(caption);
  scene.page.title = std::move(title);
  scene.page.rate = hallPhysics().control_rate;
  return scene;
}

/// Draws the marks of the paper's figure: A where the line begins, and B where the last curve begins.
void markParts(const PursuitResult& run, ReportScene& scene) {
  const auto mark = [&](const char* name, double time) {
    const auto tick = static_cast<std::size_t>(std::lround(time * scene.page.rate));
    RecordedDrawing ring;
    ring.kind = RecordedDrawing::Kind::kCircle;
    ring.from = run.robot[std::min(tick, run.robot.size() - 1)].position;
    ring.radius = 2.2 * kPoint;
    RecordedDrawing letter;
    letter.kind = RecordedDrawing::Kind::kText;
    letter.from = ring.from + Vec2{0.0, 0.16};
    letter.text = name;
    scene.page.drawings.push_back(ring);
    scene.page.drawings.push_back(letter);
  };
  const CapturePlan& plan = run.driven;
  const double last = plan.radius3 * std::abs(plan.turn3) / plan.motion.end().twist.linear;
  mark("A", plan.time1);
  mark("B", plan.motion.duration() - last);
  scene.page.drawing_ticks = static_cast<Tick>(run.robot.size());  // shows the marks for the whole scene
}

std::vector<Vec2> points(const Arc& arc, std::vector<Vec2> path) {
  constexpr int kPieces = 60;
  for (int i = 0; i <= kPieces; ++i) path.push_back(poseAt(arc, arc.length * i / kPieces).position);
  return path;
}

ReportScene curveScene(const CaptureResults& results) {
  constexpr std::size_t kSpeed = 4;  // index of 0.5 m/s
  const Pose2 start{{0.0, 0.0}, math::kPi / 2};
  const Arc single{start, -1 / PaperTables::kSingleRadius, PaperTables::kSingleRadius * PaperTables::kTurn};
  const Arc first{start, -1 / PaperTables::kDoubleRadius, PaperTables::kDoubleRadius * PaperTables::kTurn};
  const Arc second{endOf(first), 1 / PaperTables::kDoubleRadius,
                   PaperTables::kDoubleRadius * PaperTables::kTurn};
  ReportScene scene = emptyScene(
      "fig-16", "Fig. 16: single and double curve at 0.5 m/s",
      "Both are set for the dashed curves. Slip makes every curve wider by the same length, which the "
      "double curve has twice. Each robot drives in a world of its own.");
  scene.paths = {{"single, without slip", points(single, {}), true},
                 {"double, without slip", points(second, points(first, {})), true}};
  addActors({{"single curve", results.robot, &results.curves.single[kSpeed].driven.trace},
             {"double curve", results.robot, &results.curves.both[kSpeed].driven.trace}},
            Shown::kOutlines, true, scene);
  frame(scene);
  finishScene(scene);
  return scene;
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
  ReportScene scene = emptyScene(
      "fig-18", "Fig. 18: capture of a moving object",
      fmt::format(
          "Middles of the bodies every 0.5 s, as in the paper. Curve to A, line to B, curve. The robot "
          "ends {:.2f} m behind the object's middle, so each drives in a world of its own: the "
          "bodies would overlap. One robot turns its wheels as planned only, and misses.",
          run.gap));
  scene.paths = {planPath(run.driven)};
  scene.outlines_every = 0.5;
  markParts(run, scene);
  addActors({{"robot, tracks the plan", results.robot, &run.robot},
             {"object", objectModel(), &run.object},
             {"robot, wheels as planned", results.robot, &open.robot}},
            Shown::kPoints, false, scene);
  frame(scene);
  finishScene(scene);
  return scene;
}

ReportScene freeScene(const CaptureResults& results) {
  const PursuitResult& run = results.runs[kFree].result;
  ReportScene scene =
      emptyScene("fig-18-one-world", "Capture with both bodies in one world",
                 fmt::format("The robot ends {:.2f} m behind the object, which it must not touch on the way.",
                             run.gap - halfLengths(results.robot)));
  scene.paths = {planPath(run.driven)};
  markParts(run, scene);
  addActors({{"robot", results.robot, &run.robot}, {"object", objectModel(), &run.object}}, Shown::kOutlines,
            false, scene);
  scene.labels.emplace_back();  // the plan has the same colour as in fig-18
  frame(scene);
  finishScene(scene);
  return scene;
}

}  // namespace

void addScenes(const CaptureResults& results, ExperimentReport& report) {
  report.scenes = {curveScene(results), captureScene(results), freeScene(results)};
  for (ReportScene& scene : report.scenes) scene.page.seed = results.seed;
}

}  // namespace fulbito::capture
