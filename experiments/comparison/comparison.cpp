#include <array>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "engine/core/system/worker_threads.hpp"
#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/comparison/paper_figures.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "experiments/comparison/summary.hpp"
#include "experiments/trials/trial_recorder.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {
namespace {

constexpr int kMaxTrials = 1000000;
constexpr double kAwayBy = 171.0 * math::kPi / 180.0;

struct Task {
  std::size_t block;
  std::size_t navigator;
  std::uint64_t index;
};

std::vector<std::string> defaultNavigators(const Suite& suite) {
  if (suite.always_traced) return figureMethods();  // the methods that the suite's verdicts need
  std::vector<std::string> names;
  for (const NavigatorInfo& info : navigators()) names.push_back(info.name);
  return names;
}

Result<std::vector<NavigatorChoice>> parseAll(const std::vector<std::string>& specifications) {
  std::vector<NavigatorChoice> choices;
  for (const std::string& text : specifications) {
    auto choice = parseNavigator(text);
    if (!choice) return tl::unexpected<Error>(choice.error());
    choices.push_back(std::move(*choice));
  }
  return choices;
}

Result<void> checkRanges(const ComparisonConfig& config) {
  for (double speed : config.speeds) {
    if (!(speed >= 0.05 && speed <= 10.0)) {
      return fail(ErrorCode::kUsage, fmt::format("--speeds: {} is outside 0.05 ... 10 m/s", speed));
    }
  }
  if (config.trials < 0 || config.trials > kMaxTrials) {
    return fail(ErrorCode::kUsage,
                fmt::format("--trials: {} is outside 1 ... {}", config.trials, kMaxTrials));
  }
  if (config.ways < 0) return fail(ErrorCode::kUsage, fmt::format("--ways: {} is below 0", config.ways));
  if (config.pictures < 0 || config.pictures > kMaxTrials) {
    return fail(ErrorCode::kUsage,
                fmt::format("--pictures: {} is outside 0 ... {}", config.pictures, kMaxTrials));
  }
  if (config.jobs < 0 || config.jobs > 1024) {
    return fail(ErrorCode::kUsage, fmt::format("--jobs: {} is outside 1 ... 1024", config.jobs));
  }
  if (auto checked = validate(config.sensors); !checked) {
    return fail(checked.error().code, "--" + checked.error().message);
  }
  return {};
}

Result<std::vector<ComparisonBlock>> plainBlocks(const ComparisonConfig& config) {
  const auto suite = findSuite(config.suite);
  if (!suite) return tl::unexpected<Error>(suite.error());
  auto choices = parseAll(config.navigators.empty() ? defaultNavigators(**suite) : config.navigators);
  if (!choices) return tl::unexpected<Error>(choices.error());
  std::vector<ComparisonBlock> blocks;
  for (double speed : config.speeds.empty() ? (*suite)->speeds : config.speeds) {
    blocks.push_back({*suite, speed, config.trials > 0 ? config.trials : (*suite)->default_trials, *choices,
                      config.seed, StartHeading::kLayout});
  }
  return blocks;
}

std::vector<Task> tasksOf(const Comparison& comparison) {
  std::vector<Task> tasks;
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const ComparisonBlock& block = comparison.blocks[b];
    for (std::size_t n = 0; n < block.navigators.size(); ++n) {
      if (comparison.config.only) {
        tasks.push_back({b, n, *comparison.config.only});
        continue;
      }
      for (int i = 0; i < block.trials; ++i) tasks.push_back({b, n, static_cast<std::uint64_t>(i)});
    }
  }
  return tasks;
}

/// File name from layout, speed and navigator; unsuitable characters become underscores.
std::string recordingFile(const std::string& folder, const TrialConfig& config) {
  std::string name =
      fmt::format("{}-{:.1f}-{}", config.layout.name, config.robot.robot.maxSpeed(), config.navigator.text);
  for (char& c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
    if (!plain) c = '_';
  }
  return folder + "/" + name + ".fbr";
}

Result<TrialRecord> runTask(const Comparison& comparison, const Task& task, const Clock& clock) {
  const ComparisonBlock& block = comparison.blocks[task.block];
  const auto config = trialConfig(comparison, block, task.navigator, task.index);
  if (!config) return tl::unexpected<Error>(config.error());
  const bool drawn = comparison.config.only || block.suite->always_drawn ||
                     task.index < static_cast<std::uint64_t>(comparison.config.pictures);
  std::optional<TrialRecorder> recorder;
  if (drawn && !comparison.config.record.empty()) {
    auto created = TrialRecorder::create(recordingFile(comparison.config.record, *config), *config);
    if (!created) return tl::unexpected<Error>(created.error());
    recorder.emplace(std::move(*created));
  }
  auto result = runTrial(*config, clock, recorder ? &*recorder : nullptr);
  if (!result) {
    return fail(result.error().code,
                fmt::format("{} at {} m/s, {}: {}", config->layout.name, block.speed,
                            block.navigators[task.navigator].text, result.error().message));
  }
  TrialRecord record{task.block, task.navigator, task.index, result->score, result->final_hash, {}, {}, {}};
  record.compute_us.assign(result->compute_us.begin(), result->compute_us.end());
  if (drawn || block.suite->always_traced) {
    record.trace = std::move(result->trace);
    record.touches = std::move(result->touches);
  }
  return record;
}

void turnStart(Layout& layout, const ComparisonBlock& block, std::uint64_t index) {
  const double to_goal = math::angleOf(layout.goal - layout.start.position);
  if (block.heading == StartHeading::kRandom) {
    Rng rng(block.seed, Stream::kStartHeading, index);
    layout.start.heading = rng.uniform(-math::kPi, math::kPi);
  } else if (block.heading == StartHeading::kAway) {
    layout.start.heading = math::wrapAngle(to_goal + kAwayBy);
  }
}

}  // namespace

std::string_view nameOf(StartHeading heading) {
  constexpr std::array<std::string_view, 3> kNames{"goal", "random", "away"};
  return kNames[static_cast<std::size_t>(heading)];
}

RobotPreset robotAt(const RobotPreset& robot, double speed) {
  RobotPreset limited = robot;
  limited.robot.max_wheel_speed = speed / robot.robot.wheel_radius;
  return limited;
}

std::size_t referenceOf(const ComparisonBlock& block) {
  for (std::size_t n = 0; n < block.navigators.size(); ++n) {
    if (block.navigators[n].text == "bezier") return n;
  }
  return 0;
}

std::optional<MethodPlace> findMethod(const Comparison& comparison, const std::string& suite, double speed,
                                      const std::string& text) {
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const ComparisonBlock& block = comparison.blocks[b];
    if (block.suite->name != suite || block.speed != speed) continue;
    for (std::size_t n = 0; n < block.navigators.size(); ++n) {
      if (block.navigators[n].text == text) return MethodPlace{b, n};
    }
  }
  return std::nullopt;
}

Result<TrialConfig> trialConfig(const Comparison& comparison, const ComparisonBlock& block,
                                std::size_t navigator, std::uint64_t index) {
  TrialConfig config;
  config.layout = block.suite->layout(block.seed, index);
  turnStart(config.layout, block, index);
  auto field = loadField(config.layout.field);
  if (!field) return tl::unexpected<Error>(field.error());
  config.field = std::move(*field);
  config.robot = robotAt(comparison.robot, block.speed);
  config.physics = comparison.physics;
  config.navigator = block.navigators[navigator];
  config.sensors = comparison.config.sensors;
  config.sensors.heading_noise = headingNoise(config.sensors.position_noise, config.robot.robot.length);
  config.forbidden = block.suite->forbidden;
  config.limit_clearance = block.suite->limit_clearance;
  config.sonars_only = block.suite->sonars_only;
  config.seed = block.seed;
  config.index = index;
  return config;
}

Result<Comparison> prepareComparison(const ComparisonConfig& config) {
  Comparison comparison;
  comparison.config = config;
  if (auto checked = checkRanges(config); !checked) return tl::unexpected<Error>(checked.error());
  auto robot = loadRobot(config.robot);
  if (!robot) return tl::unexpected<Error>(robot.error());
  comparison.robot = std::move(*robot);
  auto physics = loadPhysics(config.physics);
  if (!physics) return tl::unexpected<Error>(physics.error());
  comparison.physics = std::move(*physics);
  return comparison;
}

Result<Comparison> planComparison(const ComparisonConfig& config) {
  auto prepared = prepareComparison(config);
  if (!prepared) return prepared;
  Comparison comparison = std::move(*prepared);
  auto blocks = config.suite == kPaperSuite ? paperBlocks(config) : plainBlocks(config);
  if (!blocks) return tl::unexpected<Error>(blocks.error());
  comparison.blocks = std::move(*blocks);
  for (const ComparisonBlock& block : comparison.blocks) {
    if (config.only && *config.only >= static_cast<std::uint64_t>(block.trials)) {
      return fail(ErrorCode::kUsage, fmt::format("--only: {} is outside 0 ... {} (suite {})", *config.only,
                                                 block.trials - 1, block.suite->name));
    }
  }
  return comparison;
}

Result<void> runComparison(Comparison& comparison, const Clock& clock, const Progress& watcher) {
  const std::vector<Task> tasks = tasksOf(comparison);
  comparison.records.assign(tasks.size(), {});
  WorkProgress progress(watcher, tasks.size());
  auto done = parallelFor(comparison.config.jobs, tasks.size(), progress, [&](std::size_t i) -> Result<void> {
    auto record = runTask(comparison, tasks[i], clock);
    if (!record) return tl::unexpected<Error>(record.error());
    comparison.records[i] = std::move(*record);
    return {};
  });
  if (!done) return done;
  summarise(comparison);
  if (comparison.config.suite == kPaperSuite && !comparison.config.only) judgeReproduction(comparison);
  return {};
}

std::span<const TrialRecord> recordsOf(const Comparison& comparison, std::size_t block,
                                       std::size_t navigator) {
  std::size_t begin = 0;
  const auto count = [&](const ComparisonBlock& b) {
    return comparison.config.only ? 1u : static_cast<std::size_t>(b.trials);
  };
  for (std::size_t b = 0; b < block; ++b)
    begin += count(comparison.blocks[b]) * comparison.blocks[b].navigators.size();
  const std::size_t each = count(comparison.blocks[block]);
  return std::span(comparison.records).subspan(begin + navigator * each, each);
}

}  // namespace fulbito
