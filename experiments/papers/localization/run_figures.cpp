#include "experiments/papers/localization/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "experiments/papers/localization/estimation/axis_decision.hpp"
#include "experiments/papers/localization/first_fix.hpp"
#include "fulbito/models.hpp"

namespace fulbito::localization {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180.0 / math::kPi;

using Runs = std::vector<CleaningResult>;

/// The values of `figure` of all runs that have it.
std::vector<double> valuesOf(const Runs& runs, double CleaningResult::* figure) {
  std::vector<double> values;
  for (const CleaningResult& run : runs) {
    if (!std::isnan(run.*figure)) values.push_back(run.*figure);
  }
  return values;
}

double greatest(const std::vector<double>& values) {
  double most = values.empty() ? kNone : 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? kNone : std::sqrt(sum / static_cast<double>(values.size()));
}

double quantileOf(std::vector<double> values, double p) { return quantile(values, p); }

int insideOf(const Runs& runs) {
  return static_cast<int>(
      std::count_if(runs.begin(), runs.end(), [](const auto& run) { return run.inside(kPaperDeviation); }));
}

double percentInside(const Runs& runs) {
  return runs.empty() ? kNone : 100.0 * insideOf(runs) / static_cast<double>(runs.size());
}

double countOf(const Runs& runs, CleaningOutcome outcome) {
  return static_cast<double>(
      std::count_if(runs.begin(), runs.end(), [&](const auto& run) { return run.outcome == outcome; }));
}

constexpr double kOpen = std::numeric_limits<double>::infinity();  // bound on an open side

PaperFigure shareFigure(const Ground& ground, Scheme scheme, const std::string& id,
                        const std::string& where) {
  return {id + "-inside",
          where,
          fmt::format("{}, {}: runs that stay within +-50 mm and come home", ground.name, nameOf(scheme)),
          "%",
          1,
          {},
          percentInside(ground.of(scheme))};
}

void addDeviations(const Ground& rooms, std::vector<PaperFigure>& figures) {
  for (const Scheme scheme : {Scheme::kThreshold, Scheme::kEkf}) {
    const std::string id = fmt::format("rooms-{}", nameOf(scheme));
    figures.push_back(shareFigure(rooms, scheme, id, "section 3"));
    figures.back().low = 99.0;
    figures.push_back(
        {id + "-worst", "section 3",
         fmt::format("{}, {}: largest deviation from the path in any run", rooms.name, nameOf(scheme)), "mm",
         1, 50.0, 1e3 * greatest(valuesOf(rooms.of(scheme), &CleaningResult::max_deviation)), -kOpen, 50.0});
  }
  figures.push_back(shareFigure(rooms, Scheme::kDeadReckoning, "rooms-dead-reckoning", "section 3"));
  figures.back().high = 50.0;
  figures.back().reason = "the comparison: without echoes most runs leave the band or hit a wall";
}

void addFields(const Batch& batch, std::vector<PaperFigure>& figures) {
  for (const Scheme scheme : {Scheme::kThreshold, Scheme::kEkf}) {
    const std::string id = fmt::format("field-{}", nameOf(scheme));
    figures.push_back(shareFigure(batch.grounds[1], scheme, id, "not in the paper"));
    figures.back().low = 95.0;
  }
}

void addAlignment(const Runs& runs, std::vector<PaperFigure>& figures) {
  const auto error = [&](double CleaningResult::* figure) {
    return kDegrees * rootMeanSquare(valuesOf(runs, figure));
  };
  figures.push_back({"heading-aligned",
                     "section 2.1",
                     "heading error after alignment",
                     "deg rms",
                     2,
                     {},
                     error(&CleaningResult::heading_error),
                     -kOpen,
                     1.5,
                     "the paper: 'so small that the eye just notices it'"});
  figures.push_back({"heading-shortest-echo",
                     "section 2.1",
                     "the same by the paper's rule, the shortest echo",
                     "deg rms",
                     2,
                     {},
                     error(&CleaningResult::shortest_echo_error),
                     -kOpen,
                     kOpen,
                     "the cone hears the perpendicular over its whole width"});
}

void addConstant(const Runs& runs, std::vector<PaperFigure>& figures) {
  figures.push_back({"constant-error",
                     "(2-1), (2-2)",
                     "largest error of the calibrated constant K, 5 to 35 degrees",
                     "%",
                     3,
                     {},
                     100.0 * greatest(valuesOf(runs, &CleaningResult::echo_speed_error)),
                     -kOpen,
                     0.5});
}

void addNominal(std::vector<PaperFigure>& figures) {
  for (const auto& [celsius, expected] : {std::pair{0.0, 79.0}, std::pair{40.0, -125.0}}) {
    figures.push_back({fmt::format("nominal-error-{:.0f}", celsius),
                       "section 2.2",
                       fmt::format("error of the fixed 0.170 mm/us over 3 m at {:.0f} degrees", celsius),
                       "mm",
                       0,
                       {},
                       1e3 * 3.0 * nominalError(celsius),
                       expected - 1.0,
                       expected + 1.0});
  }
}

void addAxis(const Ground& rooms, std::vector<PaperFigure>& figures) {
  const Runs& runs = rooms.of(Scheme::kEkf);
  figures.push_back({"wrong-axis",
                     "section 2.2",
                     "unambiguous rooms in which the robot takes the wrong axis or refuses",
                     "",
                     0,
                     {},
                     countOf(runs, CleaningOutcome::kWrongAxis) + countOf(runs, CleaningOutcome::kRefused),
                     -kOpen,
                     0.0});
  const CleaningTask& task = rooms.tasks.front();
  const double sigma = std::sqrt(2.0) * meanSigma(task.spread.range_noise);
  figures.push_back({"axis-separation-band",
                     "section 2.2",
                     "difference of the extents that a room of 4 m needs between 5 and 35 degrees",
                     "mm",
                     0,
                     {},
                     1e3 * bandSeparation(4.0, bodyOf(task.rover), sigma)});
  figures.push_back({"axis-separation-nearest",
                     "section 2.2",
                     "the same by the paper's rule, the extent nearer to K = 0.170 mm/us, without noise",
                     "mm",
                     0,
                     {},
                     1e3 * nearestSeparation(4.0, bodyOf(task.rover)),
                     -kOpen,
                     kOpen,
                     "air of 35 degrees makes the room seem 3.4 % shorter"});
}

void addConsistency(const Runs& runs, std::vector<PaperFigure>& figures) {
  figures.push_back({"ekf-consistency",
                     "not in the paper",
                     "filter's squared pose error over its covariance at the end, mean; 3 is ideal",
                     "",
                     2,
                     {},
                     mean(valuesOf(runs, &CleaningResult::squared_error)),
                     2.0,
                     4.0});
}

ReportTable schemesTable(const Batch& batch) {
  ReportTable table{
      "schemes",
      "Schemes: deviation of the true path from the reference path",
      columnsOf("ground:0 scheme:0 runs:0 home:0 hit_a_wall:0 refused:0 within_50_mm:0 median_mm:1 p99_mm:1 "
                "worst_mm:1 rms_median_mm:1 heading_worst_deg:1 final_error_median_mm:1"),
      {}};
  for (const Ground& ground : batch.grounds) {
    for (const Scheme scheme : kSchemes) {
      const Runs& runs = ground.of(scheme);
      const auto deviations = valuesOf(runs, &CleaningResult::max_deviation);
      table.rows.push_back(
          {ground.name, std::string(nameOf(scheme)), static_cast<double>(runs.size()),
           countOf(runs, CleaningOutcome::kFinished), countOf(runs, CleaningOutcome::kHitWall),
           countOf(runs, CleaningOutcome::kRefused), static_cast<double>(insideOf(runs)),
           1e3 * quantileOf(deviations, 0.5), 1e3 * quantileOf(deviations, 0.99), 1e3 * greatest(deviations),
           1e3 * quantileOf(valuesOf(runs, &CleaningResult::rms_deviation), 0.5),
           kDegrees * greatest(valuesOf(runs, &CleaningResult::max_heading_error)),
           1e3 * quantileOf(valuesOf(runs, &CleaningResult::final_error), 0.5)});
    }
  }
  return table;
}

ReportTable alignmentTable(const Batch& batch) {
  ReportTable table{"alignment",
                    "Heading error after alignment, by rule",
                    columnsOf("ground:0 rule:0 runs:0 rms_deg:2 worst_deg:2"),
                    {}};
  for (const Ground& ground : batch.grounds) {
    const auto add = [&](const char* rule, double CleaningResult::* error) {
      const auto errors = valuesOf(ground.of(Scheme::kEkf), error);
      table.rows.push_back({ground.name, rule, static_cast<double>(errors.size()),
                            kDegrees * rootMeanSquare(errors), kDegrees * greatest(errors)});
    };
    add("shortest echo (paper)", &CleaningResult::shortest_echo_error);
    add("middle of the near-shortest echoes", &CleaningResult::level_centre_error);
    add("fit of the cone's shape (used)", &CleaningResult::heading_error);
  }
  return table;
}

ReportTable runsTable(const Ground& rooms) {
  ReportTable table{
      "rooms",
      "Runs in random rooms",
      columnsOf("x_m y_m celsius:1 k_mm_per_us:5 k_error_pct:3 heading_deg:2 start_error_mm:1 route_m:1"),
      {},
      8};
  for (const Scheme scheme : kSchemes) {
    const std::string name(scheme == Scheme::kDeadReckoning ? "dead_reckoning" : nameOf(scheme));
    table.columns.push_back({name + "_mm", 1});
    table.columns.push_back({name, 0});
  }
  for (std::size_t i = 0; i < rooms.tasks.size(); ++i) {
    const CleaningTask& task = rooms.tasks[i];
    const CleaningResult& first = rooms.of(Scheme::kEkf)[i];
    std::vector<ReportCell> row{task.field.length,
                                task.field.width,
                                task.celsius,
                                1e-3 * first.echo_speed,
                                100.0 * first.echo_speed_error,
                                kDegrees * first.heading_error,
                                1e3 * first.start_error,
                                first.route_length};
    for (const Scheme scheme : kSchemes) {
      const CleaningResult& run = rooms.of(scheme)[i];
      row.emplace_back(1e3 * run.max_deviation);
      row.emplace_back(std::string(nameOf(run.outcome)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable refusalsTable(const Batch& batch) {
  ReportTable table{
      "refusals", "Rooms and starts that were refused, with the reason", columnsOf("what:0 reason:0"), {}, 4};
  for (const std::string& reason : batch.refused_rooms) table.rows.push_back({"room before any run", reason});
  for (const Ground& ground : batch.grounds) {
    for (const CleaningResult& run : ground.of(Scheme::kEkf)) {
      if (run.outcome == CleaningOutcome::kRefused) table.rows.push_back({ground.name, run.reason});
    }
  }
  return table;
}

}  // namespace

std::vector<PaperFigure> runFigures(const Batch& batch) {
  std::vector<PaperFigure> figures;
  const Ground& rooms = batch.grounds.front();
  const Runs& runs = rooms.of(Scheme::kEkf);
  addAlignment(runs, figures);
  addAxis(rooms, figures);
  addNominal(figures);
  addConstant(runs, figures);
  addDeviations(rooms, figures);
  addConsistency(runs, figures);
  addFields(batch, figures);
  return figures;
}

std::vector<ReportTable> runTables(const Batch& batch) {
  return {schemesTable(batch), alignmentTable(batch), runsTable(batch.grounds.front()), refusalsTable(batch)};
}

}  // namespace fulbito::localization
