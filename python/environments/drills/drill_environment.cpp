#include "python/environments/drills/drill_environment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/core/base/float_mode.hpp"
#include "engine/core/math/random.hpp"
#include "python/environments/match/actions.hpp"
#include "python/environments/match/painter.hpp"
#include "python/environments/match/starts.hpp"
#include "python/environments/match/truth.hpp"
#include "python/environments/numbered_start.hpp"
#include "python/environments/sight.hpp"

namespace fulbito {
namespace {

constexpr int kMostTicks = 60;
constexpr std::size_t kTeam = 3;  // robots per team in all observations, so that a policy fits all drills
constexpr std::uint64_t kTrainSeeds = std::uint64_t{1} << 63;
constexpr std::uint32_t kTrialNumbers = 1u << 20;  // numbers that a seed draws from: each start many times
constexpr std::uint64_t kLastTrial = 1'000'000'000;

bool predicts(const Drill& drill) { return drill.starts.front().task == DrillTask::kPredictBall; }

std::size_t actionSize(const DrillSettings& settings) {
  return predicts(settings.drill) ? 2 : numbersOf(settings.actions);
}

bool isAgents(const DrillRobot& robot, const DrillStart& start) {
  return robot.team == TeamId::kBlue && (robot.start.empty() || robot.start == start.name);
}

/// The robots of the tested team in that start; all of the rules' if the referee places them.
std::vector<int> ownRobots(const Drill& drill, const DrillStart& start) {
  std::vector<int> numbers;
  int next = 0;
  for (const DrillRobot& robot : drill.robots) {
    if (!isAgents(robot, start)) continue;
    numbers.push_back(robot.number >= 0 ? robot.number : next);
    next = numbers.back() + 1;
  }
  if (numbers.empty() && start.restart >= 0) {
    const auto rules = loadRules(drill.rules);
    for (int i = 0; rules && i < rules->team_size; ++i) numbers.push_back(i);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

EpisodeShape shapeOf(const DrillSettings& settings) {
  EpisodeShape shape;
  shape.observation = RobotSight(kTeam).size();
  shape.bound = kSightBound;
  shape.action = actionSize(settings);
  shape.terms.assign(kDrillTerms.begin(), kDrillTerms.end());
  shape.figures = {"success", "time", "ideal", "counted", "start", "trial"};
  return shape;
}

Result<void> check(const DrillSettings& settings) {
  if (auto trials = checkHasTrials(settings.drill); !trials) return trials;
  if (settings.actions == ActionForm::kSkill || settings.actions == ActionForm::kCompat) {
    return fail(ErrorCode::kUsage, "actions: a drill has wheels, twist and goto");
  }
  if (settings.ticks < 1 || settings.ticks > kMostTicks) {
    return fail(ErrorCode::kUsage,
                fmt::format("frame_skip: {} is outside 1 ... {}", settings.ticks, kMostTicks));
  }
  for (std::size_t i = 0; i < settings.weights.size(); ++i) {
    if (std::isfinite(settings.weights[i])) continue;
    return fail(ErrorCode::kUsage, fmt::format("rewards: {} is not finite", kDrillTerms[i]));
  }
  for (const DrillStart& start : settings.drill.starts) {
    if (auto agent = agentOf(settings.drill, start, settings.robot); !agent) {
      return tl::unexpected<Error>(agent.error());
    }
  }
  if (settings.sight) return validate(*settings.sight);
  return {};
}

}  // namespace

Result<int> agentOf(const Drill& drill, const DrillStart& start, int asked) {
  const std::vector<int> numbers = ownRobots(drill, start);
  const auto has = [&](int number) {
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  };
  if (asked < 0 && has(drill.agent)) return drill.agent;
  if (asked < 0 && !numbers.empty()) return numbers.front();
  if (has(asked)) return asked;
  return fail(ErrorCode::kUsage,
              fmt::format("robot: drill {} '{}' has no own robot {} in its start '{}'; it has {}",
                          drill.number, drill.name, std::max(asked, 0), start.name,
                          numbers.empty() ? "none" : fmt::format("{}", fmt::join(numbers, ", "))));
}

DrillEnvironment::DrillEnvironment(const DrillSettings& settings)
    : settings_(settings), shape_(shapeOf(settings)), run_{options_, {}, {}} {
  options_.catalogue = settings_.catalogue;
  options_.itself = settings_.itself;
}

DrillEnvironment::~DrillEnvironment() { (void)leave(); }

Result<std::unique_ptr<DrillEnvironment>> DrillEnvironment::create(const DrillSettings& settings) {
  if (auto checked = check(settings); !checked) return tl::unexpected<Error>(checked.error());
  std::unique_ptr<DrillEnvironment> made(new DrillEnvironment(settings));
  auto robot = loadRobot(settings.robot_model);
  if (!robot) return tl::unexpected<Error>(robot.error());
  made->run_.robot = std::move(*robot);
  auto physics = loadPhysics(settings.physics);
  if (!physics) return tl::unexpected<Error>(physics.error());
  made->run_.physics = std::move(*physics);
  auto navigator = parseNavigator(settings.navigator);
  if (!navigator) return tl::unexpected<Error>(navigator.error());
  made->navigator_ = std::move(*navigator);
  auto base = drillMatch(made->run_, settings.drill);
  if (!base) return tl::unexpected<Error>(base.error());
  made->base_ = std::move(*base);
  made->models_ = made->base_.robot;
  MatchTask ranged;
  ranged.match = made->base_;
  ranged.ranges = settings.ranges;
  if (auto checked = checkRanges(ranged); !checked) return tl::unexpected<Error>(checked.error());
  if (settings.sight) made->base_.vision.fill(*settings.sight);
  return made;
}

/// The trial that an episode plays: a function of its seed and text.
Result<DrillTrialNumber> DrillEnvironment::numberOf(const EpisodeStart& start) const {
  if (start.text.empty()) {
    Rng rng(start.seed, Stream::kEpisodeStart);
    const auto index = static_cast<int>(rng.below(kTrialNumbers));
    const bool train = settings_.split == DrillSplit::kTrain;
    return DrillTrialNumber{train ? start.seed | kTrainSeeds : start.seed & ~kTrainSeeds, index};
  }
  const auto named = readNumberedStart(start.text, "trial", options_.seed);
  if (named && named->number && *named->number <= kLastTrial) {
    return DrillTrialNumber{named->seed, static_cast<int>(*named->number)};
  }
  return fail(ErrorCode::kUsage,
              fmt::format("start: '{}' is not 'trial N' or 'trial N of seed S' with N in 0 ... {}",
                          start.text, kLastTrial));
}

/// Sets the tested team: the agent's robot, and mates only where the start has other own robots.
void DrillEnvironment::seat(const DrillStart& start) {
  robot_ = *agentOf(settings_.drill, start, settings_.robot);
  slot_->drives = {};
  slot_->drives[static_cast<std::size_t>(robot_)] = true;
  slot_->commands = {};
  slot_->answer = {};
  std::optional<TeamChoice> mates;
  if (ownRobots(settings_.drill, start).size() > 1) mates = settings_.mates;
  options_.team = agentTeam("agent", slot_, mates, navigator_);
}

Result<void> DrillEnvironment::begin(const EpisodeStart& start, const EpisodeView& out) {
  const FloatMode floats;
  const auto number = numberOf(start);
  if (!number) return tl::unexpected<Error>(number.error());
  number_ = *number;
  if (auto left = leave(); !left) return left;
  const auto& starts = settings_.drill.starts;
  seat(starts[static_cast<std::size_t>(number_.index) % starts.size()]);
  drawModels(settings_.ranges, start.seed, base_.robot = models_);
  run_.robot = base_.robot;
  auto trial = DrillTrialRun::create(run_, settings_.drill, base_, number_);
  if (!trial) return tl::unexpected<Error>(trial.error());
  trial_ = std::move(*trial);
  if (auto recorded = startRecording(); !recorded) return recorded;
  paid_ = false;
  last_action_ = {};
  settle();
  progress_ = drillProgress(*trial_, robot_, run_.robot);
  std::fill(out.rewards.begin(), out.rewards.end(), 0.0);
  std::fill(out.terms.begin(), out.terms.end(), 0.0);
  tell(out);
  return {};
}

/// Ends the episode and its recording.
Result<void> DrillEnvironment::leave() {
  if (trial_) trial_->match().finish();
  Result<void> written;
  if (recorder_) written = recorder_->written();
  trial_.reset();
  recorder_.reset();
  return written;
}

Result<void> DrillEnvironment::startRecording() {
  if (record_to_.empty()) return {};
  auto recorder = MatchRecorder::create(std::exchange(record_to_, {}), trial_->match().config());
  if (!recorder) return tl::unexpected<Error>(recorder.error());
  recorder_.emplace(std::move(*recorder));
  trial_->match().watch(*recorder_);
  return {};
}

/// Goes on to the next decision, or to the end of the trial.
void DrillEnvironment::settle() {
  while (trial_->advance() && trial_->match().phase() != MatchPhase::kDeciding) {
  }
}

void DrillEnvironment::command(std::span<const float> action) {
  effort_ = 0.0;
  for (std::size_t i = 0; i < action.size(); ++i) {
    const double number = std::clamp(double{action[i]}, -1.0, 1.0);
    effort_ += std::abs(number - last_action_[i]) / static_cast<double>(action.size());
    last_action_[i] = number;
  }
  if (predicts(settings_.drill)) {
    const FieldGeometry& field = base_.field;
    slot_->answer = {last_action_[0] * field.length / 2, last_action_[1] * field.width / 2};
  } else {
    slot_->commands[static_cast<std::size_t>(robot_)] =
        commandOf(settings_.actions, trial_->match().config(), action);
  }
}

Result<EpisodeEnd> DrillEnvironment::step(std::span<const float> actions, const EpisodeView& out) {
  const FloatMode floats;
  command(actions);
  const double before = trial_->watch().elapsed();
  for (int tick = 0; tick < settings_.ticks && !trial_->over(); ++tick) settle();
  if (const auto abandoned = trial_->match().faults().abandoned) return tl::unexpected<Error>(*abandoned);
  const DrillProgressNow progress = progress_;
  reward(std::max(0.0, trial_->watch().elapsed() - std::max(0.0, before)), progress, out);
  tell(out);
  if (trial_->over() && recorder_) {
    trial_->match().finish();
    if (auto written = recorder_->written(); !written) return tl::unexpected<Error>(written.error());
  }
  return ending();
}

void DrillEnvironment::reward(double seconds, const DrillProgressNow& before, const EpisodeView& out) {
  progress_ = drillProgress(*trial_, robot_, run_.robot);
  const DrillWatch& watch = trial_->watch();
  const auto pay = [&](DrillTerm term, double amount) {
    out.terms[static_cast<std::size_t>(term)] = settings_.weights[static_cast<std::size_t>(term)] * amount;
  };
  const bool over = trial_->over();
  const bool answered = over && predicts(settings_.drill);
  pay(DrillTerm::kSuccess, watch.succeeded() && !paid_ ? 1.0 : 0.0);
  pay(DrillTerm::kFailure, over && !watch.succeeded() ? -1.0 : 0.0);
  // A failure takes the whole time of the trial, so that nobody gains by an early one.
  const double lost = over && !watch.succeeded() ? std::max(0.0, watch.duration() - watch.elapsed()) : 0.0;
  pay(DrillTerm::kTime, -seconds - lost);
  pay(DrillTerm::kBall, progress_.ball - before.ball);
  pay(DrillTerm::kApproach, progress_.approach - before.approach);
  pay(DrillTerm::kAlign, progress_.align - before.align);
  pay(DrillTerm::kAnswer, answered ? -std::min(1.0, watch.trial(0.0).error) : 0.0);
  pay(DrillTerm::kEffort, -effort_);
  paid_ = watch.succeeded();
  out.rewards[0] = 0.0;
  for (const double term : out.terms) out.rewards[0] += term;
}

void DrillEnvironment::tell(const EpisodeView& out) const {
  // After the last tick no team sees the end of it.
  if (trial_->over()) slot_->seen = truthFor(trial_->match(), trial_->scene().seat);
  const DrillWatch& watch = trial_->watch();
  const double share = std::clamp(watch.elapsed() / watch.duration(), 0.0, 1.0);
  const MatchInfo& info = slot_->info;
  RobotSight(kTeam).write({slot_->seen, info.field, info.robot, static_cast<std::size_t>(robot_),
                           trial_->start().task, &trial_->scene().exercise, share},
                          out.observations);
  const DrillTrial verdict = watch.trial(0.0);
  out.figures[0] = verdict.success ? 1.0 : 0.0;
  out.figures[1] = verdict.success ? verdict.time : std::max(0.0, watch.elapsed());
  out.figures[2] = trial_->ideal();
  out.figures[3] = verdict.counted ? 1.0 : 0.0;
  out.figures[4] = verdict.start;
  out.figures[5] = number_.index;
}

Result<void> DrillEnvironment::record(const std::string& file) {
  record_to_ = file;
  return {};
}

Result<Canvas> DrillEnvironment::picture(int width) {
  if (!trial_) return fail(ErrorCode::kUsage, "there is no picture before the first reset");
  const auto painter = MatchPainter::create(trial_->match().config(), width);
  if (!painter) return tl::unexpected<Error>(painter.error());
  return painter->draw(trial_->match());
}

EpisodeEnd DrillEnvironment::ending() const {
  if (!trial_->over()) return {};
  const DrillWatch& watch = trial_->watch();
  const bool verdict = watch.succeeded() || watch.decided();
  return {verdict, !verdict};
}

}  // namespace fulbito
