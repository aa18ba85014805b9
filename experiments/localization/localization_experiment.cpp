#include "experiments/localization/localization_experiment.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "experiments/localization/batch.hpp"
#include "experiments/localization/run_charts.hpp"
#include "experiments/localization/run_figures.hpp"
#include "experiments/localization/run_scene.hpp"

namespace fulbito::localization {
namespace {

struct Range {
  double low, high;
  bool whole = false;
};

/// A setting as a number. Errors: kUsage naming it.
Result<double> numberOf(const ExperimentRequest& request, const std::string& name, double initial,
                        Range range) {
  const auto text = request.find(name);
  if (!text) return initial;
  double value = 0.0;
  const auto [end, code] = std::from_chars(text->data(), text->data() + text->size(), value);
  const bool read = code == std::errc() && end == text->data() + text->size();
  const bool fits = value >= range.low && value <= range.high && (!range.whole || value == std::floor(value));
  if (read && fits) return value;
  return fail(ErrorCode::kUsage,
              fmt::format("experiment localization: {}='{}' is not {} from {} to {}", name, *text,
                          range.whole ? "a whole number" : "a number", range.low, range.high));
}

Result<BatchSize> sizeOf(const ExperimentRequest& request) {
  BatchSize size;
  const auto rooms = numberOf(request, "rooms", static_cast<double>(size.rooms), {1, 10000, true});
  if (!rooms) return tl::unexpected<Error>(rooms.error());
  const auto fields = numberOf(request, "fields", static_cast<double>(size.fields), {1, 10000, true});
  if (!fields) return tl::unexpected<Error>(fields.error());
  const auto wrong = numberOf(request, "wrong", static_cast<double>(size.wrong), {0, 10000, true});
  if (!wrong) return tl::unexpected<Error>(wrong.error());
  const auto noise = numberOf(request, "noise", size.spread.range_noise, {0.001, 0.05});
  if (!noise) return tl::unexpected<Error>(noise.error());
  size.rooms = static_cast<std::size_t>(*rooms);
  size.fields = static_cast<std::size_t>(*fields);
  size.wrong = static_cast<std::size_t>(*wrong);
  size.spread.range_noise = *noise;
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

PaperExperiment localizationExperiment() {
  return {"localization",
          "a robot finds its place in a room by ultrasonic sensors, and cleans it",
          "J.-Y. Jeong et al., The Absolute Position Recognition Using the Map in Space for Navigation of a "
          "Mobile "
          "Robot",
          {{"rooms", "200", "random rooms"},
           {"fields", "40", "starts on each form of the soccer field"},
           {"noise", "0.008", "standard deviation of a range [m], 0.001 to 0.05"},
           {"wrong", "0", "random rooms for each wrong noise figure told to the robot; 0: none"}},
          run};
}

}  // namespace fulbito::localization
