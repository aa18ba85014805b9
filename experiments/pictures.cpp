#include "experiments/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "replays/render/bar_chart.hpp"
#include "replays/render/field_picture.hpp"

namespace fulbito {
namespace {

constexpr double kFootprintEvery = 0.15;  // [m] of way between outlined bodies
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::string remarkOf(const TrialScore& score) {
  const std::string figures = fmt::format("{:.2f} s, {:.2f} m", score.time, score.length);
  return score.success() ? figures
                         : std::string(nameOf(score.outcome)) + (score.arrived ? ", " + figures : "");
}

DrawnPath drawnPath(const std::string& label, const TrialScore& score, const std::vector<TraceRow>& trace,
                    bool bodies) {
  DrawnPath path;
  path.label = label;
  path.remark = remarkOf(score);
  path.failed = !score.success();
  double since = kFootprintEvery;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const Pose2& pose = trace[i].robot.pose;
    if (i > 0) since += distance(pose.position, trace[i - 1].robot.pose.position);
    path.points.push_back(pose.position);
    if (bodies && since >= kFootprintEvery) {
      path.footprints.push_back(pose);
      since = 0.0;
    }
  }
  return path;
}

/// The way of a moving obstacle in the first `seconds`: all of a long trial's would fill the field.
void shorten(ObstacleSpec& obstacle, double seconds) {
  if (obstacle.motion != ObstacleMotion::kPath || obstacle.path_end != PathEnd::kStop) return;
  double left = obstacle.speed * seconds;
  for (std::size_t i = 1; i < obstacle.path.size(); ++i) {
    left -= distance(obstacle.path[i - 1], obstacle.path[i]);
    if (left > 0.0) continue;
    obstacle.path.resize(i + 1);
    obstacle.path.back() = positionAt(obstacle, seconds);
    return;
  }
}

FieldPicture pictureOf(const std::string& title, const TrialConfig& config) {
  FieldPicture picture;
  picture.title = title;
  picture.field = config.field;
  picture.robot = config.robot.robot;
  picture.layout = config.layout;
  return picture;
}

/// Draws the obstacles' ways for as long as the longest of the paths took.
void limitMotion(FieldPicture& picture, double dt) {
  std::size_t ticks = 1;
  for (const DrawnPath& path : picture.paths) ticks = std::max(ticks, path.points.size());
  for (ObstacleSpec& obstacle : picture.layout.obstacles) shorten(obstacle, static_cast<double>(ticks) * dt);
}

Result<void> save(Result<Canvas> canvas, const std::string& file) {
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  return canvas->writePng(file);
}

/// A bar for each navigator that solved anything; the others say so.
BarChart chartOf(const Comparison& comparison, const std::string& title, const std::string& axis,
                 double SummaryRow::* ratio) {
  BarChart chart;
  chart.title = title;
  chart.axis = axis;
  chart.has_reference = true;
  chart.reference = 1.0;
  chart.reference_label = "limit";
  std::size_t row = 0;
  std::vector<std::string> seen;  // a method has one colour in all groups
  for (const Block& block : comparison.blocks) {
    BarGroup group{fmt::format("{} at {:.1f} m/s", block.suite->name, block.speed), {}};
    for (std::size_t n = 0; n < block.navigators.size(); ++n) {
      const SummaryRow& s = comparison.summary[row++];
      Bar bar;
      bar.label = s.navigator;
      bar.value = s.success.value > 0.0 ? s.*ratio : kNoValue;
      bar.remark =
          s.success.value > 0.0 ? fmt::format("{:.0f} % solved", 100 * s.success.value) : "none solved";
      bar.colour = static_cast<std::size_t>(std::find(seen.begin(), seen.end(), s.navigator) - seen.begin());
      if (bar.colour == seen.size()) seen.push_back(s.navigator);
      group.bars.push_back(std::move(bar));
    }
    chart.groups.push_back(std::move(group));
  }
  return chart;
}

}  // namespace

Result<void> writePathPicture(const std::string& file, const std::string& title, const TrialConfig& config,
                              const std::vector<const TrialRecord*>& records,
                              const std::vector<std::string>& labels) {
  FieldPicture picture = pictureOf(title, config);
  for (std::size_t i = 0; i < records.size(); ++i) {
    picture.paths.push_back(drawnPath(labels[i], records[i]->score, records[i]->trace, false));
  }
  limitMotion(picture, config.physics.controlPeriod());
  return save(drawFieldPicture(picture), file);
}

Result<void> writeTrialPicture(const std::string& file, const TrialConfig& config,
                               const TrialResult& result) {
  FieldPicture picture =
      pictureOf(fmt::format("{} at {:.1f} m/s", config.layout.name, config.robot.robot.maxSpeed()), config);
  TrialScore limit;
  limit.outcome = TrialOutcome::kReached;
  limit.time = result.score.time_limit;
  limit.length = result.score.length_limit;
  picture.paths.push_back(drawnPath(config.navigator.text, result.score, result.trace, true));
  limitMotion(picture, config.physics.controlPeriod());
  DrawnPath shortest;
  shortest.label = "limit L*, T*";
  shortest.remark = remarkOf(limit);
  shortest.points = result.limit_path;
  picture.paths.push_back(std::move(shortest));
  return save(drawFieldPicture(picture), file);
}

Result<std::vector<std::string>> writePictures(const Comparison& comparison, const std::string& folder) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& name, Result<void> written) -> Result<void> {
    if (written) files.push_back(name);
    return written;
  };
  const auto file_of = [&](const std::string& name) { return folder + "/" + name; };
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const Block& block = comparison.blocks[b];
    const std::size_t layouts = recordsOf(comparison, b, 0).size();
    for (std::size_t i = 0; i < layouts; ++i) {
      if (recordsOf(comparison, b, 0)[i].trace.empty()) continue;
      std::vector<const TrialRecord*> records;
      std::vector<std::string> labels;
      for (std::size_t n = 0; n < block.navigators.size(); ++n) {
        records.push_back(&recordsOf(comparison, b, n)[i]);
        labels.push_back(block.navigators[n].text);
      }
      const std::uint64_t index = records.front()->index;
      const auto config = trialConfig(comparison, block, 0, index);
      if (!config) return tl::unexpected<Error>(config.error());
      const std::string name = fmt::format("{}-{:.1f}.png", config->layout.name, block.speed);
      const std::string title = fmt::format("{} at {:.1f} m/s", config->layout.name, block.speed);
      auto written = add(name, writePathPicture(file_of(name), title, *config, records, labels));
      if (!written) return tl::unexpected<Error>(written.error());
    }
  }
  for (const auto& [name, title, axis, member] :
       {std::tuple{"time.png", "Time of successful runs", "time / T*", &SummaryRow::time_ratio},
        std::tuple{"distance.png", "Distance of successful runs", "length / L*",
                   &SummaryRow::length_ratio}}) {
    auto written = add(name, save(drawBarChart(chartOf(comparison, title, axis, member)), file_of(name)));
    if (!written) return tl::unexpected<Error>(written.error());
  }
  return files;
}

}  // namespace fulbito
