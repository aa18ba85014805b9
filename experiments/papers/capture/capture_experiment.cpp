#include <array>
#include <cmath>

#include "experiments/papers/capture/capture_results.hpp"
#include "experiments/papers/capture/fig18.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr int kDraws = 500;         // number of draws per row of the study of estimators
constexpr std::size_t kAgain = 30;  // number of captures of Fig. 18 with other sighting errors

/// The settings as plain numbers, for the common parser.
struct Values {
  double gap = 0.24;           // [m]
  double range_noise = 0.02;   // [m]
  double bearing_noise = 0.5;  // [degrees]
  int captures = 100;
};

std::vector<Parameter<Values>> parameters() {
  return {
      number("gap", &Values::gap, 0.05, 1.0, "m", "wanted distance to the object at the end"),
      number("range_noise", &Values::range_noise, 0.0, 0.5, "m", "standard deviation of the camera's range"),
      number("bearing_noise", &Values::bearing_noise, 0.0, 10.0, "degrees",
             "standard deviation of the camera's bearing"),
      integer("captures", &Values::captures, 0, 2000, "random captures")};
}

Result<CaptureSettings> settingsIn(const ExperimentRequest& request) {
  Values values;
  if (auto set = applySettings(parameters(), request.settings, "capture", values); !set) {
    return tl::unexpected<Error>(set.error());
  }
  return CaptureSettings{values.gap, {values.range_noise, values.bearing_noise * kDegree}, values.captures};
}

std::vector<Fig18Run> waysOf(const CaptureResults& results, std::uint64_t seed) {
  const double gap = results.settings.gap;
  const PursuitSetup noisy = fig18Setup(results.robot, gap, results.settings.noise, seed);
  PursuitSetup perfect = noisy;
  perfect.noise = {};
  PursuitSetup as_planned = perfect;
  as_planned.drive = PursuitDrive::kOpen;
  PursuitSetup ideal = as_planned;
  ideal.robot.curve_widening = ideal.robot.curve_widening_rise = 0.0;
  PursuitSetup free = noisy;
  free.together = true;
  free.gap = gap + halfLengths(results.robot);
  free.limits = limitsWithoutTouch(results.robot);
  return {{"no slip, wheels as planned", ideal, {}},
          {"slip, wheels as planned", as_planned, {}},
          {"slip, tracked, perfect camera", perfect, {}},
          {"slip, tracked", noisy, {}},
          {"slip, tracked, gap between the bodies", free, {}}};
}

/// Drives the capture in all ways. Errors: of the world; kUsage if the planner refuses.
Result<void> driveFig18(CaptureResults& results, std::uint64_t seed) {
  results.runs = waysOf(results, seed);
  for (Fig18Run& run : results.runs) {
    auto result = pursue(run.setup);
    if (!result) return tl::unexpected<Error>(result.error());
    if (!result->answer.plan) {
      return fail(ErrorCode::kUsage, "capture: Fig. 18 with gap = " + std::to_string(run.setup.gap) + " m (" +
                                         run.way + "): " + nameOf(result->answer.refusal));
    }
    run.result = std::move(*result);
  }
  return {};
}

Result<CaptureResults> resultsOf(const ExperimentRequest& request) {
  CaptureResults results;
  const auto settings = settingsIn(request);
  if (!settings) return tl::unexpected<Error>(settings.error());
  results.settings = *settings;
  results.seed = request.seed;
  const auto robot = loadRobot("choi-lee-2005");
  if (!robot) return tl::unexpected<Error>(robot.error());
  results.robot = robot->robot;
  auto curves = driveCurves(results.robot, request.jobs, request.progress);
  if (!curves) return tl::unexpected<Error>(curves.error());
  results.curves = std::move(*curves);
  auto errors = driveCurveErrors(results.robot);
  if (!errors) return tl::unexpected<Error>(errors.error());
  results.curve_errors = std::move(*errors);
  results.estimators = studyEstimators(request.seed, kDraws);
  if (auto driven = driveFig18(results, request.seed); !driven) return tl::unexpected<Error>(driven.error());
  auto again = captureAgain(results.runs[kTracked].setup, kAgain, request.jobs, request.progress);
  if (!again) return tl::unexpected<Error>(again.error());
  std::erase_if(*again, [](const PursuitResult& run) { return !run.answer.plan; });
  results.again = std::move(*again);
  auto random = captureAtRandom(results.robot, results.settings.gap, results.settings.noise, request.seed,
                                results.settings.captures, request.jobs, request.progress);
  if (!random) return tl::unexpected<Error>(random.error());
  results.random = std::move(*random);
  return results;
}

Result<ExperimentReport> run(const ExperimentRequest& request) {
  const auto results = resultsOf(request);
  if (!results) return tl::unexpected<Error>(results.error());
  ExperimentReport report;
  report.name = "capture";
  report.title = "Choi & Lee (2005): capture of a moving object on curves of constant curvature";
  addFigures(*results, report);
  addTables(*results, report);
  addChecks(*results, report);
  addCharts(*results, report);
  addScenes(*results, report);
  return report;
}

}  // namespace

PaperExperiment experiment() {
  return {"capture", "curves of constant curvature with slip, and the capture of a moving object",
          "B.-S. Choi and J.-M. Lee, A Capturing Algorithm of Moving Object using Single Curvature "
          "Trajectory, 2005",
          settingsOf(specsOf(parameters())), run};
}

}  // namespace fulbito::capture
