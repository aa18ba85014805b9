#include <cmath>
#include <string>

#include <fmt/format.h>

#include "experiments/papers/localization/batch.hpp"
#include "experiments/papers/localization/run_charts.hpp"
#include "experiments/papers/localization/run_figures.hpp"
#include "experiments/papers/localization/run_scene.hpp"

namespace fulbito::localization {
namespace {

struct Settings {
  int rooms = 200, fields = 40, wrong = 0;
  double noise = SensorSpread{}.range_noise;  // [m]
};

std::vector<Parameter<Settings>> parameters() {
  using S = Settings;
  return {integer("rooms", &S::rooms, 1, 10000, "random rooms"),
          integer("fields", &S::fields, 1, 10000, "starts on each form of the soccer field"),
          number("noise", &S::noise, 0.001, 0.05, "", "standard deviation of a range [m], 0.001 to 0.05"),
          integer("wrong", &S::wrong, 0, 10000,
                  "random rooms for each wrong noise figure told to the robot; 0: none")};
}

Result<BatchSize> sizeOf(const ExperimentRequest& request) {
  Settings settings;
  if (auto set = applySettings(parameters(), request.settings, "localization", settings); !set)
    return tl::unexpected<Error>(set.error());
  BatchSize size;
  size.rooms = static_cast<std::size_t>(settings.rooms);
  size.fields = static_cast<std::size_t>(settings.fields);
  size.wrong = static_cast<std::size_t>(settings.wrong);
  size.spread.range_noise = settings.noise;
  return size;
}

constexpr const char* kTicksNote = "The world runs at 20 control ticks per second with 2 physics steps each.";
constexpr const char* kFieldNote =
    "On the soccer field the robot's map is the rectangle of 1.5 x 1.3 m. The corner triangles stay; its way "
    "keeps 110 mm from the walls and so clear of them. Boards close the goals but in the last ground, where "
    "echoes from inside a goal are 100 mm too long: a start that sees one refuses, as no K fits.";
constexpr const char* kOriginNote =
    "A rectangle has two poses with the same echoes. The robot names the corner at its right (facing -y) or "
    "left (facing -x) the origin, as the paper does; the truth is seen from that corner.";

std::vector<std::string> notesOf(const Batch& batch, const SensorSpread& spread) {
  return {
      fmt::format("{} of {} rooms were refused before any run: echoes cannot tell their axes apart at all "
                  "temperatures.",
                  batch.refused_rooms.size(),
                  batch.refused_rooms.size() + batch.grounds.front().tasks.size()),
      fmt::format(
          "Noise: ranges {:.0f} mm and {:.0f} % drop-outs at 10 Hz; wheels {:.1f} % scale and {:.0f} mm "
          "slip over 1 m; gyro {:.1f} deg/s bias, {:.1f} deg/s noise, {:.2f} deg/s drift over 200 s, "
          "{:.1f} % scale. Errors of a single robot are drawn from these standard deviations.",
          1e3 * spread.range_noise, 100 * spread.dropout, 100 * spread.wheel_scale, 1e3 * spread.wheel_slip,
          spread.gyro_bias * 180 / math::kPi, spread.gyro_noise * 180 / math::kPi,
          spread.gyro_drift * std::sqrt(200.0) * 180 / math::kPi, 100 * spread.gyro_scale),
      kTicksNote, kFieldNote, kOriginNote};
}

Result<ExperimentReport> run(const ExperimentRequest& request) {
  const auto size = sizeOf(request);
  if (!size) return tl::unexpected<Error>(size.error());
  const auto batch = runBatch(*size, request.seed, request.jobs, request.progress);
  if (!batch) return tl::unexpected<Error>(batch.error());
  ExperimentReport report;
  report.name = "localization";
  report.title = "Jeong et al.: absolute position by ultrasonic sensors and the map of a room";
  report.figures = runFigures(*batch);
  report.tables = runTables(*batch);
  if (!batch->wrong.empty()) report.tables.push_back(wrongTable(batch->wrong));
  report.charts = runCharts(*batch);
  report.scenes.push_back(
      runScene(batch->example, Scheme::kThreshold, "room", "A cleaning robot in a room of known size"));
  report.scenes.push_back(
      runScene(batch->field_example, Scheme::kEkf, "field", "A small robot on the soccer field"));
  report.notes = notesOf(*batch, size->spread);
  return report;
}

}  // namespace

PaperExperiment experiment() {
  return {"localization", "a robot finds its place in a room by ultrasonic sensors, and cleans it",
          "J.-Y. Jeong et al., The Absolute Position Recognition Using the Map in Space for Navigation of a "
          "Mobile Robot",
          settingsOf(specsOf(parameters())), run};
}

}  // namespace fulbito::localization
