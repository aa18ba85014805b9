#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "engine/core/system/output_file.hpp"
#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/report/pictures.hpp"
#include "experiments/trials/trial_recorder.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::app {
namespace {

/// A layout, with the rules of its suite.
struct Problem {
  Layout layout;
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;
  double limit_clearance = 0.058;
  std::uint64_t index = 0;
  bool sonars_only = false;
};

Result<Problem> suiteProblem(const std::string& text, std::size_t colon, std::uint64_t seed) {
  const auto suite = findSuite(text.substr(0, colon));
  if (!suite) return tl::unexpected<Error>(suite.error());
  const std::string number = text.substr(colon + 1);
  if (number.empty() || number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos) {
    return fail(ErrorCode::kUsage,
                fmt::format("--layout: '{}' in '{}' is not a layout number", number, text));
  }
  const std::uint64_t index = std::stoull(number);
  return Problem{(*suite)->layout(seed, index), (*suite)->forbidden, (*suite)->limit_clearance, index,
                 (*suite)->sonars_only};
}

Result<Problem> findProblem(const std::string& text, std::uint64_t seed) {
  for (const Layout& named : namedCases()) {
    if (named.name == text) return Problem{named, ForbiddenContacts::kAll, 0.058, 0, false};
  }
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos && text.find('/') == std::string::npos)
    return suiteProblem(text, colon, seed);
  auto layout = loadLayout(text);
  if (!layout) return tl::unexpected<Error>(layout.error());
  return Problem{std::move(*layout), ForbiddenContacts::kAll, 0.058, 0, false};
}

Result<TrialConfig> configOf(const RunOptions& options) {
  auto problem = findProblem(options.layout, options.seed);
  if (!problem) return tl::unexpected<Error>(problem.error());
  auto field = loadField(problem->layout.field);
  if (!field) return tl::unexpected<Error>(field.error());
  auto robot = loadRobot(options.robot);
  if (!robot) return tl::unexpected<Error>(robot.error());
  auto physics = loadPhysics(options.physics);
  if (!physics) return tl::unexpected<Error>(physics.error());
  auto navigator = parseNavigator(options.navigator);
  if (!navigator) return tl::unexpected<Error>(navigator.error());
  TrialConfig config;
  config.layout = std::move(problem->layout);
  config.field = std::move(*field);
  config.robot = robotAt(*robot, options.speed);
  config.physics = std::move(*physics);
  config.navigator = std::move(*navigator);
  config.sensors = options.sensors;
  config.sensors.heading_noise = headingNoise(config.sensors.position_noise, config.robot.robot.length);
  config.forbidden = problem->forbidden;
  config.limit_clearance = problem->limit_clearance;
  config.sonars_only = problem->sonars_only;
  config.seed = options.seed;
  config.index = problem->index;
  return config;
}

void printScore(const TrialConfig& config, const TrialResult& result) {
  const TrialScore& s = result.score;
  std::vector<double> compute = result.compute_us;
  say("{} on {} at {:.2f} m/s (seed {}): {}\n"
      "  time       {:.3f} s    (T* {:.3f} s, ratio {:.3f})\n"
      "  length     {:.3f} m    (L* {:.3f} m, ratio {:.3f})\n"
      "  contacts   {} with obstacles ({} by own motion), {} with walls, impulse {:.4f} N s\n"
      "  clearance  {:.1f} mm least, {:.1f} mm mean\n"
      "  turning    {:.2f} rad, {} curvature jumps, wheel jerk {:.0f} m/s^3\n"
      "  compute    {:.1f} us per tick median, {:.1f} p99, {:.1f} max\n"
      "  hash       {:016x}\n",
      config.navigator.text, config.layout.name, config.robot.robot.maxSpeed(), config.seed,
      nameOf(s.outcome), s.time, s.time_limit, s.timeRatio(), s.length, s.length_limit, s.lengthRatio(),
      s.obstacle_contacts, s.own_contacts, s.wall_contacts, s.contact_impulse, 1000 * s.min_clearance,
      1000 * s.mean_clearance, s.turning, s.curvature_jumps, s.wheel_jerk, quantile(compute, 0.5),
      quantile(compute, 0.99), quantile(compute, 1.0), result.final_hash);
}

/// Name of the picture's file: the given one, or one derived from the layout.
std::string pictureOf(const RunOptions& options, const TrialConfig& config) {
  if (!options.png) return {};
  return options.png->empty() ? config.layout.name + ".png" : *options.png;
}

}  // namespace

int run(const RunOptions& options) {
  if (options.json && options.trace == "-") {
    return report({ErrorCode::kUsage, "--trace - and --json both write to stdout; give --trace a file"});
  }
  const auto config = configOf(options);
  if (!config) return report(config.error());
  if (auto may = mayWrite({"--png", pictureOf(options, *config), {OutputKind::kPng}}); !may) {
    return report(may.error());
  }
  std::optional<TrialRecorder> recorder;
  if (!options.record.empty()) {
    auto created = TrialRecorder::create(options.record, *config, options.force);
    if (!created) return report(created.error());
    recorder.emplace(std::move(*created));
    if (options.drawings) recorder->keepGuidance();
  }
  const auto result = runTrial(*config, now, recorder ? &*recorder : nullptr);
  if (!result) return report(result.error());
  if (recorder) note("recording: {}\n", options.record);
  if (options.png) {
    const std::string file = pictureOf(options, *config);
    if (auto written = writeTrialPicture(file, *config, *result); !written) return report(written.error());
    note("picture: {}\n", file);
  }
  if (!options.trace.empty()) {
    if (options.trace == "-") {
      writeOut(traceCsv(*result));
      return kOk;
    }
    if (auto written = writeFile(options.trace, traceCsv(*result)); !written) return report(written.error());
    note("trace: {}\n", options.trace);
  }
  if (options.json) {
    writeOut(trialJson(*config, *result));
  } else {
    printScore(*config, *result);
  }
  return kOk;
}

}  // namespace fulbito::app
