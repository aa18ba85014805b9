#include "experiments/papers/localization/wrong_figures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "experiments/papers/localization/random_rooms.hpp"
#include "experiments/papers/localization/run_figures.hpp"
#include "fulbito/models.hpp"

namespace fulbito::localization {
namespace {

using Apply = void (*)(CleaningTask&, double);

void tellRanges(CleaningTask& task, double factor) { task.spread.range_noise *= factor; }
void tellWheels(CleaningTask& task, double factor) { task.spread.wheel_scale *= factor; }
void tellSlip(CleaningTask& task, double factor) { task.spread.wheel_slip *= factor; }
void tellGyroNoise(CleaningTask& task, double factor) { task.spread.gyro_noise *= factor; }
void tellGyroDrift(CleaningTask& task, double factor) { task.spread.gyro_drift *= factor; }
void tellGyroScale(CleaningTask& task, double factor) { task.spread.gyro_scale *= factor; }

void tellAll(CleaningTask& task, double factor) {
  for (const Apply tell : {tellRanges, tellWheels, tellSlip, tellGyroNoise, tellGyroDrift, tellGyroScale})
    tell(task, factor);
}

void scaleGyro(CleaningTask& task, double factor) { task.rover.gyro.scale *= factor; }

void scaleWheels(CleaningTask& task, double factor) {
  task.rover.encoders.left_scale *= factor;
  task.rover.encoders.right_scale *= factor;
}

void warm(CleaningTask& task, double kelvin) { task.warming = kelvin; }
void setAir(CleaningTask& task, double celsius) { task.celsius = celsius; }

void addTold(std::vector<WrongCase>& cases, const char* what, bool filter_only, Apply apply) {
  for (const auto& [amount, factor] :
       {std::pair{"x 1/8", 0.125}, {"x 1/4", 0.25}, {"x 1/2", 0.5}, {"x 2", 2.0}, {"x 4", 4.0}, {"x 8", 8.0}})
    cases.push_back({what, amount, filter_only, apply, factor});
}

/// Counts and sizes of the results in one case.
struct Tally {
  double home = 0, wall = 0, refused = 0, wrong_axis = 0, inside = 0;
  std::vector<double> deviations, squared_errors;

  explicit Tally(const std::vector<CleaningResult>& results) {
    for (const CleaningResult& run : results) {
      home += run.outcome == CleaningOutcome::kFinished ? 1 : 0;
      wall += run.outcome == CleaningOutcome::kHitWall ? 1 : 0;
      refused += run.outcome == CleaningOutcome::kRefused ? 1 : 0;
      wrong_axis += run.outcome == CleaningOutcome::kWrongAxis ? 1 : 0;
      inside += run.inside(kPaperDeviation) ? 1 : 0;
      if (!std::isnan(run.max_deviation)) deviations.push_back(run.max_deviation);
      if (!std::isnan(run.squared_error)) squared_errors.push_back(run.squared_error);
    }
  }
};

}  // namespace

std::vector<WrongCase> wrongCases() {
  std::vector<WrongCase> cases{{"nothing wrong", "-", false, tellAll, 1.0}};
  addTold(cases, "range noise told", false, tellRanges);
  addTold(cases, "wheel scale's spread told", true, tellWheels);
  addTold(cases, "wheel slip told", true, tellSlip);
  addTold(cases, "gyro noise told", true, tellGyroNoise);
  addTold(cases, "gyro drift told", true, tellGyroDrift);
  addTold(cases, "gyro scale's spread told", true, tellGyroScale);
  addTold(cases, "all six told", false, tellAll);
  for (const double percent : {1.0, 2.0, 5.0, 10.0})
    cases.push_back(
        {"gyro reads too much", fmt::format("{:g} %", percent), false, scaleGyro, 1 + percent / 100});
  for (const double percent : {2.0, 5.0, 10.0})
    cases.push_back(
        {"both wheels read too much", fmt::format("{:g} %", percent), false, scaleWheels, 1 + percent / 100});
  for (const double kelvin : {5.0, 10.0, 20.0})
    cases.push_back({"air warms after the first fix", fmt::format("{:g} K", kelvin), false, warm, kelvin});
  for (const double celsius : {0.0, 3.0, 37.0, 40.0})
    cases.push_back(
        {"air outside 5 to 35 degrees", fmt::format("{:g} degrees", celsius), false, setAir, celsius});
  return cases;
}

Result<std::vector<WrongRuns>> runWrongFigures(const std::vector<WrongCase>& cases, std::size_t rooms,
                                               std::uint64_t seed, const SensorSpread& spread, int jobs,
                                               const WorkWatcher& watcher) {
  std::vector<WrongRuns> all;
  if (rooms == 0) return all;
  const std::vector<CleaningTask> tasks = randomRooms(rooms, seed, spread).tasks;
  for (const WrongCase& wrong : cases) {
    for (const Scheme scheme : {Scheme::kThreshold, Scheme::kEkf}) {
      if (wrong.filter_only && scheme != Scheme::kEkf) continue;
      all.push_back({wrong, scheme, std::vector<CleaningResult>(rooms)});
    }
  }
  WorkProgress progress(watcher, all.size() * rooms);
  auto done = parallelFor(jobs, all.size() * rooms, progress, [&](std::size_t i) -> Result<void> {
    WrongRuns& runs = all[i / rooms];
    CleaningTask task = tasks[i % rooms];
    runs.wrong.apply(task, runs.wrong.value);
    auto result = runCleaning(task, runs.scheme);
    if (!result) return tl::unexpected<Error>(result.error());
    runs.results[i % rooms] = std::move(*result);
    return {};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return all;
}

ReportTable wrongTable(const std::vector<WrongRuns>& runs) {
  ReportTable table{
      "wrong-figures",
      "Noise figures told wrong, sensors worse than stated: share of runs within 50 mm and home",
      columnsOf("what:0 amount:0 scheme:0 runs:0 within_pct:1 home:0 hit_a_wall:0 refused:0 wrong_axis:0 "
                "median_mm:1 worst_mm:1 nees:2"),
      {},
      100};
  for (const WrongRuns& run : runs) {
    Tally tally(run.results);
    const auto count = static_cast<double>(run.results.size());
    const double worst = tally.deviations.empty()
                             ? std::nan("")
                             : *std::max_element(tally.deviations.begin(), tally.deviations.end());
    table.rows.push_back({run.wrong.what, run.wrong.amount, std::string(nameOf(run.scheme)), count,
                          100 * tally.inside / count, tally.home, tally.wall, tally.refused, tally.wrong_axis,
                          1e3 * quantile(tally.deviations, 0.5), 1e3 * worst, mean(tally.squared_errors)});
  }
  return table;
}

}  // namespace fulbito::localization
