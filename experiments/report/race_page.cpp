#include "experiments/report/race_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/comparison/comparison_parts.hpp"
#include "fulbito/detail/build_info.hpp"

namespace fulbito {
namespace {

constexpr double kRowRate = 30.0;  // [Hz]

/// The bodies of a race: one robot per navigator, then the obstacles.
std::vector<PageBody> bodiesOf(const TrialConfig& config, std::size_t navigators) {
  const RobotModel& robot = config.robot.robot;
  const PageBody runner{BodyKind::kRobot, {}, true, robot.length, robot.width, 0.0};
  std::vector<PageBody> bodies(navigators, runner);
  for (const ObstacleSpec& spec : config.layout.obstacles) {
    bodies.push_back(
        {BodyKind::kObstacle, {}, spec.shape == ObstacleShape::kBox, spec.length, spec.width, spec.radius});
  }
  return bodies;
}

PageRow rowAt(const TrialConfig& config, std::span<const TrialRecord* const> records, Tick tick) {
  PageRow row{tick, {}};
  for (const TrialRecord* record : records) {
    const std::size_t last = record->trace.size() - 1;
    row.poses.push_back(record->trace[std::min(static_cast<std::size_t>(tick), last)].robot.pose);
  }
  const double seconds = static_cast<double>(tick) * config.physics.controlPeriod();
  for (const ObstacleSpec& spec : config.layout.obstacles) {
    row.poses.push_back({positionAt(spec, seconds), spec.pose.heading});
  }
  return row;
}

/// Adds the rows of all runs. A finished robot stays at its last place until the last robot has finished.
void addRows(const TrialConfig& config, std::span<const TrialRecord* const> records, PageScene& scene) {
  for (const TrialRecord* record : records) {
    scene.ticks = std::max(scene.ticks, static_cast<Tick>(record->trace.size()) - 1);
  }
  const auto stride =
      std::max<Tick>(1, static_cast<Tick>(std::floor(config.physics.control_rate / kRowRate + 0.5)));
  for (Tick tick = 0; tick < scene.ticks; tick += stride) scene.rows.push_back(rowAt(config, records, tick));
  scene.rows.push_back(rowAt(config, records, scene.ticks));
  PagePlay play;
  play.present.assign(scene.bodies.size(), 1);
  scene.plays.push_back(std::move(play));
}

PageRun runOf(const TrialRecord& record, const NavigatorChoice& navigator) {
  const TrialScore& score = record.score;
  return {navigator.text,     std::string(nameOf(score.outcome)),
          score.success(),    score.time,
          score.length,       score.timeRatio(),
          score.lengthRatio()};
}

PageScene raceOf(const Comparison& comparison, const ComparisonBlock& block, const TrialConfig& config,
                 std::span<const TrialRecord* const> records) {
  PageScene scene;
  scene.title = fmt::format("{} at {:.1f} m/s", config.layout.name, block.speed);
  scene.field = config.field;
  scene.rate = config.physics.control_rate;
  scene.bodies = bodiesOf(config, records.size());
  const Layout& layout = config.layout;
  scene.task = PageTask{layout.start, layout.goal, layout.goal_tolerance, layout.goal_heading};
  scene.seed = comparison.config.seed;
  for (std::size_t n = 0; n < records.size(); ++n) {
    scene.runs.push_back(runOf(*records[n], block.navigators[n]));
  }
  addRows(config, records, scene);
  scene.facts = {
      {"Suite", block.suite->name},       {"Layout", fmt::format("{}", records.front()->index)},
      {"Robot", config.robot.robot.name}, {"Top speed", fmt::format("{:.2f} m/s", block.speed)},
      {"Physics", config.physics.name},   {"Made by", fmt::format("Fulbito {}", buildInfo().version)}};
  return scene;
}

}  // namespace

Result<Page> racePage(const Comparison& comparison) {
  Page page{PageKind::kRaces, fmt::format("Race of navigators, {}", comparison.config.suite), {}};
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const ComparisonBlock& block = comparison.blocks[b];
    for (std::size_t i = 0; i < recordsOf(comparison, b, 0).size(); ++i) {
      std::vector<const TrialRecord*> records;
      records.reserve(block.navigators.size());
      for (std::size_t n = 0; n < block.navigators.size(); ++n) {
        records.push_back(&recordsOf(comparison, b, n)[i]);
      }
      if (records.front()->trace.empty()) continue;
      const auto config = trialConfig(comparison, block, 0, records.front()->index);
      if (!config) return tl::unexpected<Error>(config.error());
      page.scenes.push_back(raceOf(comparison, block, *config, records));
    }
  }
  if (page.scenes.empty()) return fail(ErrorCode::kUsage, "--html: --pictures 0 keeps no way to show");
  return page;
}

}  // namespace fulbito
