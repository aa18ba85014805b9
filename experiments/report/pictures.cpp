#include "experiments/report/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/comparison/paper_bars.hpp"
#include "experiments/comparison/paper_figures.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "experiments/report/drawn_ways.hpp"
#include "experiments/report/field_arrows.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/field/bar_chart.hpp"

namespace fulbito {
namespace {

constexpr Vec2 kShown{1050, 810};         // [px] size of a picture of a window
constexpr double kFootprintEvery = 0.15;  // [m] path length between outlines of the body
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::string remarkOf(const TrialScore& score) {
  const std::string figures = fmt::format("{:.2f} s, {:.2f} m", score.time, score.length);
  return score.success() ? figures
                         : std::string(nameOf(score.outcome)) + (score.arrived ? ", " + figures : "");
}

/// The colour of a method, which is the same in all pictures.
std::size_t colourOf(const NavigatorChoice& navigator) {
  std::size_t index = 0;
  for (const NavigatorInfo& info : navigators()) {
    if (info.name == navigator.info->name) return index;
    ++index;
  }
  return index;
}

/// Makes all but the first path of each colour hollow.
void markVariants(std::vector<DrawnPath>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths[i].hollow = std::any_of(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(i),
                                  [&](const DrawnPath& before) { return before.colour == paths[i].colour; });
  }
}

DrawnPath drawnPath(const NavigatorChoice& navigator, const TrialScore& score,
                    const std::vector<TraceRow>& trace, const std::vector<Touch>& touches, bool bodies) {
  DrawnPath path;
  path.label = navigator.text;
  path.remark = remarkOf(score);
  path.failed = !score.success();
  path.arrived = score.arrived;
  for (const Touch& touch : touches) path.touches.push_back(touch.point);
  path.colour = colourOf(navigator);
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

/// Shortens an obstacle's path to the first `seconds`, since a long trial's path would fill the field.
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

/// An empty picture with the title and window of the paper's figure if the layout belongs to one.
FieldPicture pictureOf(const TrialConfig& config) {
  FieldPicture picture;
  const FigureCase* figure = figureOf(config.layout.name);
  const double speed = config.robot.robot.maxSpeed();
  picture.title = figure != nullptr ? fmt::format("{}, top speed {:.1f} m/s", figure->title, speed)
                                    : fmt::format("Ways through layout {} at a top speed of {:.1f} m/s",
                                                  config.layout.name, speed);
  if (figure != nullptr && figure->window) {
    picture.window = FieldWindow{figure->window->first, figure->window->second};
    const Vec2 size = picture.window->high - picture.window->low;
    picture.pixels_per_metre = static_cast<int>(std::min(kShown.x / size.x, kShown.y / size.y));
  }
  picture.field = config.field;
  picture.robot = config.robot.robot;
  picture.layout = config.layout;
  return picture;
}

/// Limits the obstacles' paths to the duration of the longest run.
void limitMotion(FieldPicture& picture, double dt) {
  std::size_t ticks = 1;
  for (const DrawnPath& path : picture.paths) ticks = std::max(ticks, path.points.size());
  for (ObstacleSpec& obstacle : picture.layout.obstacles) shorten(obstacle, static_cast<double>(ticks) * dt);
}

Result<void> save(Result<Canvas> canvas, const std::string& file) {
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  return canvas->writePng(file);
}

/// Caption with the statement of the paper's figure, its rule, and the result of `method`.
std::string captionOf(const FigureCase& figure, const std::string& method, const FigureVerdict& verdict) {
  return fmt::format("Jung & Lee (2015): {}. To show it, a run {}. Here {} {}: it {}.", figure.sentence,
                     ruleText(figure), method, verdict.measured, verdict.shown ? "shows it" : "does not");
}

/// Adds the arrows of a field method over the shown part of the field.
Result<void> addArrows(FieldPicture& picture, const TrialConfig& config) {
  FieldWindow shown{{-config.field.length / 2, -config.field.width / 2},
                    {config.field.length / 2, config.field.width / 2}};
  if (picture.window) shown = *picture.window;
  auto places = fieldArrows(config, shown.low, shown.high);
  if (!places) return tl::unexpected<Error>(places.error());
  picture.arrows = {fmt::format("the field at the start"), arrowSpacing(shown.low, shown.high) * 0.62,
                    std::move(*places)};
  return {};
}

/// A bar for each navigator with at least one success, and a text for each of the others.
BarChart chartOf(const Comparison& comparison, const std::string& title, const std::string& axis,
                 double SummaryRow::* ratio) {
  BarChart chart;
  chart.title = title;
  chart.axis = axis;
  chart.has_reference = true;
  chart.reference = 1.0;
  chart.reference_label = "limit";
  std::size_t row = 0;
  for (const ComparisonBlock& block : comparison.blocks) {
    BarGroup group{fmt::format("{} at {:.1f} m/s", block.suite->name, block.speed), {}};
    std::vector<std::size_t> seen;
    for (const NavigatorChoice& navigator : block.navigators) {
      const SummaryRow& s = comparison.summary[row++];
      Bar bar;
      bar.label = s.navigator;
      bar.value = s.success.value > 0.0 ? s.*ratio : kNoValue;
      bar.remark =
          s.success.value > 0.0 ? fmt::format("{:.0f} % solved", 100 * s.success.value) : "none solved";
      bar.colour = colourOf(navigator);
      bar.hollow = std::find(seen.begin(), seen.end(), bar.colour) != seen.end();
      seen.push_back(bar.colour);
      group.bars.push_back(std::move(bar));
    }
    chart.groups.push_back(std::move(group));
  }
  return chart;
}

/// The first layouts of Fig. 28 or 29 as bars, like in the paper.
BarChart barsChart(const PaperBars& bars, bool length) {
  constexpr std::size_t kLayouts = 6;
  BarChart chart;
  chart.title = fmt::format("{} of Jung & Lee (2015) here, {} at {:.1f} m/s; the paper saves {:.1f} %",
                            bars.paper->figure, bars.suite, bars.speed,
                            -100 * (length ? bars.paper->length : bars.paper->time));
  chart.axis = length ? "driven way [m]" : "time [s]";
  const auto colour = [](const std::string& text) {
    const auto choice = parseNavigator(text);
    return choice ? colourOf(*choice) : 0;
  };
  for (std::size_t i = 0; i < std::min(kLayouts, bars.pairs.size()); ++i) {
    const LayoutPair& p = bars.pairs[i];
    BarGroup group{fmt::format("layout {}", p.index), {}};
    const double field = length ? p.field_length : p.field_time,
                 bezier = length ? p.bezier_length : p.bezier_time;
    group.bars.push_back({bars.field, field, 0.0, 0.0, "", colour(bars.field), false});
    group.bars.push_back({bars.bezier, bezier, 0.0, 0.0,
                          fmt::format("{:+.1f} %", 100 * (bezier / field - 1.0)), colour(bars.bezier),
                          false});
    chart.groups.push_back(std::move(group));
  }
  return chart;
}

}  // namespace

Result<void> writePathPicture(const std::string& file, const Comparison& comparison, std::size_t b,
                              std::uint64_t index) {
  const ComparisonBlock& block = comparison.blocks[b];
  const auto config = trialConfig(comparison, block, 0, index);
  if (!config) return tl::unexpected<Error>(config.error());
  FieldPicture picture = pictureOf(*config);
  const FigureCase* figure = figureOf(config->layout.name);
  const std::vector<std::size_t> drawn = drawnWays(comparison, b, figure);
  if (figure == nullptr && drawn.size() < block.navigators.size()) {
    picture.caption =
        fmt::format("{} of {} ways: the methods of Jung & Lee (2015), then the fastest. --ways 0 draws all.",
                    drawn.size(), block.navigators.size());
  }
  for (std::size_t n : drawn) {
    for (const TrialRecord& record : recordsOf(comparison, b, n)) {
      if (record.index != index) continue;
      picture.paths.push_back(
          drawnPath(block.navigators[n], record.score, record.trace, record.touches, false));
      const FigureRun* run = figure == nullptr ? nullptr : runOf(*figure, block.navigators[n].text);
      if (run == nullptr || !run->judged || !picture.caption.empty()) continue;
      picture.caption = captionOf(*figure, run->navigator, judgeRun(*figure, config->layout, record));
      const auto own = trialConfig(comparison, block, n, index);
      if (!own) return tl::unexpected<Error>(own.error());
      if (auto added = addArrows(picture, *own); !added) return added;
    }
  }
  markVariants(picture.paths);
  limitMotion(picture, config->physics.controlPeriod());
  return save(drawFieldPicture(picture), file);
}

Result<void> writeTrialPicture(const std::string& file, const TrialConfig& config,
                               const TrialResult& result) {
  FieldPicture picture = pictureOf(config);
  TrialRecord run;
  run.score = result.score, run.trace = result.trace, run.touches = result.touches;
  if (const FigureCase* figure = figureOf(config.layout.name)) {
    picture.caption = captionOf(*figure, config.navigator.text, judgeRun(*figure, config.layout, run));
  }
  if (auto added = addArrows(picture, config); !added) return added;
  picture.paths.push_back(drawnPath(config.navigator, result.score, result.trace, result.touches, true));
  limitMotion(picture, config.physics.controlPeriod());
  TrialScore limit;
  limit.outcome = TrialOutcome::kReached;
  limit.time = result.score.time_limit;
  limit.length = result.score.length_limit;
  DrawnPath shortest;
  shortest.label = "limit L*, T*";
  shortest.remark = remarkOf(limit);
  shortest.points = result.limit_path;
  shortest.colour = picture.paths.front().colour == std::size_t{0} ? 1 : 0;
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
    const ComparisonBlock& block = comparison.blocks[b];
    const std::size_t layouts = recordsOf(comparison, b, 0).size();
    for (std::size_t i = 0; i < layouts; ++i) {
      if (recordsOf(comparison, b, 0)[i].trace.empty()) continue;
      const std::uint64_t index = recordsOf(comparison, b, 0)[i].index;
      const bool some =
          index < static_cast<std::uint64_t>(comparison.config.pictures) || comparison.config.only;
      if (block.suite->always_traced && !some) continue;
      const Layout layout = block.suite->layout(block.seed, index);
      const std::string name = fmt::format("{}-{:.1f}.png", layout.name, block.speed);
      auto written = add(name, writePathPicture(file_of(name), comparison, b, index));
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
  if (comparison.config.suite != kPaperSuite) return files;
  for (const PaperBars& bars : paperBars(comparison)) {
    if (bars.pairs.empty()) continue;
    for (const bool length : {true, false}) {
      const std::string name = fmt::format("{}-{}.png", bars.paper == &kPaperTargets[0] ? "fig28" : "fig29",
                                           length ? "distance" : "time");
      auto written = add(name, save(drawBarChart(barsChart(bars, length)), file_of(name)));
      if (!written) return tl::unexpected<Error>(written.error());
    }
  }
  return files;
}

}  // namespace fulbito
