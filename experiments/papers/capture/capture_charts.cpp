#include <cmath>

#include <fmt/format.h>

#include "experiments/papers/capture/capture_results.hpp"
#include "experiments/papers/capture/hall.hpp"
#include "experiments/papers/capture/paper_tables.hpp"

namespace fulbito::capture {
namespace {

/// A chart line over the speeds of the paper.
ChartLine overSpeed(std::string label, bool paper, std::size_t colour, const auto& value) {
  ChartLine line;
  line.label = std::move(label);
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i)
    line.points.push_back({PaperTables::kSpeeds[i], value(i)});
  line.dots = true;
  line.dashed = paper;
  line.colour = colour;
  return line;
}

LineChart chartOf(const char* title, const char* caption, const char* y_axis) {
  LineChart chart;
  chart.title = title, chart.caption = caption, chart.x_axis = "speed [m/s]", chart.y_axis = y_axis;
  return chart;
}

LineChart errorChart(const CurveTable& curves) {
  LineChart chart =
      chartOf("Fig. 17: error over speed",
              "The paper's error is that of the radius for the single curve and that of the end for the "
              "double one. Dashed: the paper.",
              "error [m]");
  chart.lines = {
      overSpeed("single, radius", false, 0,
                [&](std::size_t i) { return curves.single[i].driven.radius1 - PaperTables::kSingleRadius; }),
      overSpeed("single, paper", true, 0, [](std::size_t i) { return PaperTables::kSingle[i].error; }),
      overSpeed("double, end", false, 1, [&](std::size_t i) { return curves.both[i].driven.end_error; }),
      overSpeed("double, paper", true, 1, [](std::size_t i) { return PaperTables::kDouble[i].error; }),
      overSpeed("single, end", false, 2, [&](std::size_t i) { return curves.single[i].driven.end_error; })};
  return chart;
}

LineChart distanceChart(const CurveTable& curves) {
  LineChart chart = chartOf("Fig. 17: distance over speed",
                            "Without slip both are 7.18 m. Dashed: the paper.", "distance [m]");
  chart.from_zero = false;
  chart.lines = {
      overSpeed("single", false, 0, [&](std::size_t i) { return curves.single[i].driven.distance; }),
      overSpeed("single, paper", true, 0, [](std::size_t i) { return PaperTables::kSingle[i].distance; }),
      overSpeed("double", false, 1, [&](std::size_t i) { return curves.both[i].driven.distance; }),
      overSpeed("double, paper", true, 1, [](std::size_t i) { return PaperTables::kDouble[i].distance; })};
  return chart;
}

LineChart timeChart(const CurveTable& curves) {
  LineChart chart = chartOf("Fig. 17: time over speed", "Dashed: the paper.", "time [s]");
  chart.lines = {
      overSpeed("single", false, 0,
                [&](std::size_t i) { return curves.single[i].time(PaperTables::kSpeeds[i]); }),
      overSpeed("single, paper", true, 0, [](std::size_t i) { return PaperTables::kSingle[i].time; }),
      overSpeed("double", false, 1,
                [&](std::size_t i) { return curves.both[i].time(PaperTables::kSpeeds[i]); }),
      overSpeed("double, paper", true, 1, [](std::size_t i) { return PaperTables::kDouble[i].time; })};
  return chart;
}

LineChart radiusChart(const CaptureResults& results) {
  LineChart chart = chartOf("Fig. 7: error of a curve over speed and radius", "", "error [m]");
  chart.caption = fmt::format(
      "After {:.1f} m, from where a robot without slip is. It grows with speed, and is larger on smaller "
      "radii. The paper's figure is of another robot.",
      kErrorWay);
  for (const CurveError& error : results.curve_errors) {
    const std::string label = fmt::format("radius {:g} m", error.radius);
    if (chart.lines.empty() || chart.lines.back().label != label) chart.lines.push_back({label, {}, true});
    chart.lines.back().points.push_back({error.speed, error.error});
  }
  return chart;
}

/// Speed along a trace, as a mean over half a second.
ChartLine speedLine(const char* label, const std::vector<Pose2>& trace) {
  ChartLine line;
  line.label = label;
  const double dt = hallPhysics().controlPeriod();
  constexpr std::size_t kStride = 30;
  for (std::size_t i = kStride; i < trace.size(); i += kStride) {
    const double way = distance(trace[i - kStride].position, trace[i].position);
    line.points.push_back({(static_cast<double>(i) - kStride / 2.0) * dt, way / (kStride * dt)});
  }
  return line;
}

LineChart captureChart(const CaptureResults& results) {
  const PursuitResult& run = results.runs[kTracked].result;
  LineChart chart;
  chart.title = "Fig. 18: speeds on the way to the capture";
  chart.caption =
      "First curve at full acceleration, line with the slowdown, last curve at the object's speed.";
  chart.x_axis = "time [s]", chart.y_axis = "speed [m/s]";
  ChartLine plan;
  plan.label = "plan";
  plan.dashed = true;
  for (int i = 0; i * 0.25 <= run.driven.motion.duration(); ++i) {
    const double t = i * 0.25;
    plan.points.push_back({t, run.driven.motion.at(t).twist.linear});
  }
  chart.lines = {speedLine("robot", run.robot), speedLine("object", run.object), plan};
  chart.marks = {{run.driven.time1, "line"},
                 {run.time - run.driven.radius3 * std::abs(run.driven.turn3) / 0.3, "last curve"}};
  return chart;
}

/// Errors of the current estimate during the capture.
LineChart estimateChart(const CaptureResults& results) {
  const Fig18Run& run = results.runs[kTracked];
  LineChart chart;
  chart.title = "Fig. 18: where the estimate expects the object at the end";
  chart.caption = "Distance from where it is then. Ten sightings a second.";
  chart.x_axis = "time [s]", chart.y_axis = "error [m]";
  ChartLine line;
  for (const ObjectMotion& estimate : run.result.estimates) {
    line.points.push_back(
        {estimate.time, distance(estimate.at(run.result.time), run.setup.object.at(run.result.time))});
  }
  chart.lines = {line};
  chart.marks = {{run.result.driven.time1, "planned again"}};
  return chart;
}

}  // namespace

void addCharts(const CaptureResults& results, ExperimentReport& report) {
  report.charts = {{"fig-7-error", radiusChart(results)},
                   {"fig-17-error", errorChart(results.curves)},
                   {"fig-17-distance", distanceChart(results.curves)},
                   {"fig-17-time", timeChart(results.curves)},
                   {"fig-18-speeds", captureChart(results)},
                   {"fig-18-estimate", estimateChart(results)}};
}

}  // namespace fulbito::capture
