#include "experiments/papers/localization/run_charts.hpp"

#include <string>

#include <fmt/format.h>

#include "experiments/papers/localization/estimation/axis_decision.hpp"
#include "experiments/papers/localization/run_figures.hpp"

namespace fulbito::localization {
namespace {

constexpr double kDegrees = 180.0 / math::kPi;

/// A chart line along the route of one scheme's example.
template <typename Value>
ChartLine lineOf(const Batch& batch, Scheme scheme, const Value& value) {
  ChartLine line;
  const CleaningResult& run = batch.example.of(scheme).front();
  line.label = fmt::format("{}: {}", nameOf(scheme), nameOf(run.outcome));
  for (const CleaningMoment& moment : run.moments) line.points.push_back({moment.way, value(moment)});
  return line;
}

double routeLength(const Batch& batch) { return batch.example.of(Scheme::kEkf).front().route_length; }

std::string roomText(const CleaningTask& task) {
  return fmt::format("Room {:.1f} x {:.1f} m, {:.0f} degrees.", task.field.length, task.field.width,
                     task.celsius);
}

LineChart deviationChart(const Batch& batch) {
  LineChart chart;
  chart.title = "Deviation of the true path from the reference path";
  chart.caption = roomText(batch.example.tasks.front()) +
                  " Dead reckoning has encoders and gyro alone; the others correct it by echoes.";
  chart.x_axis = "way along the route [m]";
  chart.y_axis = "deviation [mm]";
  for (const Scheme scheme : kSchemes)
    chart.lines.push_back(lineOf(batch, scheme, [](const auto& m) { return 1e3 * m.deviation; }));
  ChartLine bound{"bound of the paper",
                  {{0.0, 1e3 * kPaperDeviation}, {routeLength(batch), 1e3 * kPaperDeviation}}};
  bound.dashed = true;
  bound.colour = 5;
  chart.lines.push_back(bound);
  return chart;
}

LineChart headingChart(const Batch& batch) {
  LineChart chart;
  chart.title = "Error of the estimated heading";
  chart.caption = roomText(batch.example.tasks.front()) +
                  " The gyro's bias is known to 0.03 deg/s at the start and drifts from there.";
  chart.x_axis = "way along the route [m]";
  chart.y_axis = "estimate minus truth [deg]";
  for (const Scheme scheme : kSchemes) {
    chart.lines.push_back(lineOf(batch, scheme, [](const auto& m) {
      return kDegrees * math::wrapAngle(m.estimate.heading - m.truth.heading);
    }));
  }
  return chart;
}

LineChart constantChart(const Batch& batch) {
  LineChart chart;
  chart.title = "Constant from echo time to distance";
  chart.caption = "Calibrated in each random room from its known extent, (2-1) and (2-2); a dot per run.";
  chart.x_axis = "temperature [degrees C]";
  chart.y_axis = "error of the constant [%]";
  chart.from_zero = false;
  ChartLine calibrated{"calibrated in the room", {}};
  calibrated.dots = true;
  calibrated.joined = false;
  const Ground& rooms = batch.grounds.front();
  for (std::size_t i = 0; i < rooms.tasks.size(); ++i) {
    const double error = rooms.of(Scheme::kEkf)[i].echo_speed_error;
    calibrated.points.push_back({rooms.tasks[i].celsius, 100.0 * error});
  }
  ChartLine fixed{"fixed 0.170 mm/us", {}};
  fixed.dashed = true;
  for (int celsius = 5; celsius <= 35; ++celsius)
    fixed.points.push_back({static_cast<double>(celsius), 100.0 * nominalError(celsius)});
  chart.lines = {calibrated, fixed};
  return chart;
}

}  // namespace

std::vector<ReportChart> runCharts(const Batch& batch) {
  return {{"deviation", deviationChart(batch)},
          {"heading", headingChart(batch)},
          {"constant", constantChart(batch)}};
}

}  // namespace fulbito::localization
