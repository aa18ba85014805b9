#include "experiments/papers/hybrid/hybrid_runs.hpp"

#include <algorithm>

#include "fulbito/report.hpp"
#include "fulbito/sensors.hpp"

namespace fulbito::hybrid {
namespace {

constexpr const char* kOurs = "hybrid";
constexpr const char* kAsPrinted = "hybrid-raw";
constexpr const char* kWithoutDiagram = "hybrid-without-nd";
// The shortest path of a robot that keeps 1 cm from its circumscribed circle: 12.6 cm, wider than all gaps.
constexpr const char* kDirectlyRound = "tangent-graph:margin=0.01";
constexpr double kSquareClearance = 0.0395;  // [m] half the robot's width + 2 mm, as in the suite

/// One trial to run and where its score goes.
struct Task {
  Layout layout;
  Knowledge knowledge;
  std::string navigator;
  std::uint64_t index;
  TrialScore* score;
};

/// The width of the narrowest gap between two obstacles of the row that a robot passes at all.
double gapOf(const Layout& layout, double robot_width) {
  double gap = 1e9;
  for (const ObstacleSpec& a : layout.obstacles) {
    for (const ObstacleSpec& b : layout.obstacles) {
      const double between = distance(a.pose.position, b.pose.position) - a.radius - b.radius;
      if (between > robot_width) gap = std::min(gap, between);
    }
  }
  return gap;
}

HybridRuns emptyRuns(const HybridSettings& settings, std::uint64_t seed, double robot_width) {
  HybridRuns runs;
  runs.settings = settings;
  for (double widths : {1.1, 1.3, 1.6}) {
    const int count = widths == 1.3 ? settings.gaps : settings.gaps / 2;
    for (Knowledge knowledge : {Knowledge::kSonars, Knowledge::kFineSonars, Knowledge::kMap}) {
      if (knowledge == Knowledge::kFineSonars && widths != 1.3) continue;
      GapBlock block{widths, knowledge, {}};
      block.scores.resize(static_cast<std::size_t>(count));
      runs.gaps.push_back(std::move(block));
    }
  }
  for (int i = 0; i < settings.rows; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    runs.rows.push_back({index, gapOf(anyRowLayout(seed, index), robot_width), {}, {}, {}});
  }
  for (GapKind kind : kGapKinds) {
    for (Knowledge knowledge : {Knowledge::kSonars, Knowledge::kFineSonars}) {
      for (const char* navigator : {kOurs, kAsPrinted, kWithoutDiagram}) {
        KindBlock block{kind, knowledge, navigator, {}};
        block.scores.resize(static_cast<std::size_t>(settings.kinds));
        runs.kinds.push_back(std::move(block));
      }
    }
  }
  return runs;
}

std::vector<Task> tasksOf(HybridRuns& runs, std::uint64_t seed) {
  std::vector<Task> tasks;
  for (GapBlock& block : runs.gaps) {
    for (std::size_t i = 0; i < block.scores.size(); ++i)
      tasks.push_back({gapLayout(seed, i, block.widths), block.knowledge, kOurs, i, &block.scores[i]});
  }
  for (RowPair& pair : runs.rows) {
    const Layout layout = anyRowLayout(seed, pair.index);
    tasks.push_back({layout, Knowledge::kSonars, kOurs, pair.index, &pair.with});
    tasks.push_back({layout, Knowledge::kSonars, kWithoutDiagram, pair.index, &pair.without});
    tasks.push_back({layout, Knowledge::kMap, kDirectlyRound, pair.index, &pair.around});
  }
  for (KindBlock& block : runs.kinds) {
    for (std::size_t i = 0; i < block.scores.size(); ++i)
      tasks.push_back(
          {gapOfKind(block.kind, seed, i, 1.3), block.knowledge, block.navigator, i, &block.scores[i]});
  }
  return tasks;
}

}  // namespace

Result<TrialConfig> hybridTrial(const Layout& layout, Knowledge knowledge, bool with_diagram, double speed,
                                std::uint64_t seed, std::uint64_t index) {
  return sonarTrial(layout, knowledge, with_diagram ? kOurs : kWithoutDiagram, speed, seed, index);
}

Result<TrialConfig> sonarTrial(const Layout& layout, Knowledge knowledge, const std::string& choice,
                               double speed, std::uint64_t seed, std::uint64_t index) {
  auto field = loadField(layout.field);
  if (!field) return tl::unexpected<Error>(field.error());
  auto robot = loadRobot("jung-lee-2015");
  if (!robot) return tl::unexpected<Error>(robot.error());
  auto physics = loadPhysics("standard");
  if (!physics) return tl::unexpected<Error>(physics.error());
  auto navigator = parseBuiltInNavigator(choice);
  if (!navigator) return tl::unexpected<Error>(navigator.error());
  TrialConfig config;
  config.layout = layout;
  config.field = std::move(*field);
  config.robot = std::move(*robot);
  config.robot.robot.max_wheel_speed = speed / config.robot.robot.wheel_radius;
  config.physics = std::move(*physics);
  config.navigator = std::move(*navigator);
  config.limit_clearance = kSquareClearance;
  config.sonars_only = knowledge != Knowledge::kMap;
  if (knowledge == Knowledge::kFineSonars) config.sonar_noise *= pioneerScale(config.robot.robot);
  config.seed = seed;
  config.index = index;
  return config;
}

Result<HybridRuns> runHybrid(const HybridSettings& settings, const ExperimentRequest& request) {
  const auto robot = loadRobot("jung-lee-2015");
  if (!robot) return tl::unexpected<Error>(robot.error());
  HybridRuns runs = emptyRuns(settings, request.seed, robot->robot.width);
  const std::vector<Task> tasks = tasksOf(runs, request.seed);
  WorkProgress progress(request.progress, tasks.size());
  auto done = parallelFor(request.jobs, tasks.size(), progress, [&](std::size_t i) -> Result<void> {
    const Task& task = tasks[i];
    const auto config =
        sonarTrial(task.layout, task.knowledge, task.navigator, settings.speed, request.seed, task.index);
    if (!config) return tl::unexpected<Error>(config.error());
    const auto result = runTrial(*config, {});
    if (!result) return tl::unexpected<Error>(result.error());
    *task.score = result->score;
    return {};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return runs;
}

}  // namespace fulbito::hybrid
