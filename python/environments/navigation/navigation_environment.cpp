#include "python/environments/navigation/navigation_environment.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/float_mode.hpp"
#include "engine/core/math/random.hpp"
#include "experiments/comparison/comparison_parts.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/picture.hpp"
#include "python/environments/numbered_start.hpp"

namespace fulbito {
namespace {

constexpr int kMostTicks = 60;
constexpr std::uint64_t kTrainSeeds = std::uint64_t{1} << 63;
constexpr std::uint32_t kLayoutNumbers = 1u << 20;  // numbers that a seed draws from
constexpr double kNear = 0.03;                      // [m] gap between robot and obstacle that counts as near

EpisodeShape shapeOf() {
  EpisodeShape shape;
  shape.observation = kNavigationSightNumbers;
  shape.bound = kSightBound;
  shape.action = 2;
  shape.terms.assign(kNavigationTerms.begin(), kNavigationTerms.end());
  shape.figures = {"success",      "outcome",  "time",      "time_ratio", "length",
                   "length_ratio", "contacts", "clearance", "layout"};
  return shape;
}

Result<void> check(const NavigationSettings& settings) {
  if (settings.ticks < 1 || settings.ticks > kMostTicks) {
    return fail(ErrorCode::kUsage,
                fmt::format("frame_skip: {} is outside 1 ... {}", settings.ticks, kMostTicks));
  }
  if (!(settings.speed >= 0.05 && settings.speed <= 10.0)) {
    return fail(ErrorCode::kUsage, fmt::format("speed: {} is outside 0.05 ... 10 m/s", settings.speed));
  }
  for (std::size_t i = 0; i < settings.weights.size(); ++i) {
    if (std::isfinite(settings.weights[i])) continue;
    return fail(ErrorCode::kUsage, fmt::format("rewards: {} is not finite", kNavigationTerms[i]));
  }
  return {};
}

/// The number of the suite's layout of that name. Errors: kUsage if there is none.
Result<std::uint64_t> numberOf(const Suite& suite, std::uint64_t seed, std::string_view name) {
  for (int i = 0; i < suite.default_trials; ++i) {
    if (suite.layout(seed, static_cast<std::uint64_t>(i)).name == name) return static_cast<std::uint64_t>(i);
  }
  return fail(
      ErrorCode::kUsage,
      fmt::format("start: '{}' is not a number or the name of a layout of suite '{}'", name, suite.name));
}

}  // namespace

/// The guidance that the agent's action is: a direction and a speed.
class NavigationEnvironment::Steering final : public Navigator, public HeadingField {
 public:
  void reset() override {}
  Guidance plan(const NavigationScene&) override {
    Guidance guidance = guidanceBy(*this);
    guidance.speed_cap = speed;
    return guidance;
  }
  double heading(Vec2) const override { return direction; }

  double direction = 0.0;  ///< [rad]
  double speed = 0.0;      ///< [m/s]
};

NavigationEnvironment::NavigationEnvironment(const NavigationSettings& settings)
    : settings_(settings), shape_(shapeOf()) {
  auto steering = std::make_unique<Steering>();
  steering_ = steering.get();
  pilot_.emplace(std::move(steering));
}

Result<std::unique_ptr<NavigationEnvironment>> NavigationEnvironment::create(
    const NavigationSettings& settings) {
  if (auto checked = check(settings); !checked) return tl::unexpected<Error>(checked.error());
  std::unique_ptr<NavigationEnvironment> made(new NavigationEnvironment(settings));
  ComparisonConfig config;
  config.suite = settings.suite;
  config.navigators = {"straight"};
  config.speeds = {settings.speed};
  config.robot = settings.robot;
  config.physics = settings.physics;
  config.sensors = settings.sensors;
  if (const auto suite = findSuite(settings.suite); !suite) return tl::unexpected<Error>(suite.error());
  auto plan = planComparison(config);
  if (!plan) return tl::unexpected<Error>(plan.error());
  made->plan_ = std::move(*plan);
  made->plan_.blocks.front().heading = settings.heading;
  if (settings.layout) {
    auto field = loadField(settings.layout->field);
    if (!field) return tl::unexpected<Error>(field.error());
    if (auto fits = validate(*settings.layout, *field); !fits) return tl::unexpected<Error>(fits.error());
  }
  return made;
}

/// Sets the trial's configuration: a function of the episode's seed and text.
Result<void> NavigationEnvironment::place(const EpisodeStart& start) {
  ComparisonBlock& block = plan_.blocks.front();
  std::uint64_t index = 0;
  block.seed = start.seed;
  if (start.text.empty()) {
    Rng rng(start.seed, Stream::kEpisodeStart);
    index = rng.below(kLayoutNumbers);
    block.seed = settings_.train ? start.seed | kTrainSeeds : start.seed & ~kTrainSeeds;
  } else if (const auto named = readNumberedStart(start.text, "layout", plan_.config.seed); !named) {
    return fail(
        ErrorCode::kUsage,
        fmt::format("start: '{}' is not 'layout N', 'layout N of seed S' or 'layout NAME'", start.text));
  } else {
    block.seed = named->seed;
    const auto found = named->number ? Result<std::uint64_t>(*named->number)
                                     : numberOf(*block.suite, named->seed, named->name);
    if (!found) return tl::unexpected<Error>(found.error());
    index = *found;
  }
  auto config = trialConfig(plan_, block, 0, index);
  if (!config) return tl::unexpected<Error>(config.error());
  if (settings_.layout) {
    config->layout = *settings_.layout;
    auto field = loadField(config->layout.field);
    if (!field) return tl::unexpected<Error>(field.error());
    config->field = std::move(*field);
  }
  trial_.reset();
  config_ = std::move(*config);
  return {};
}

Result<void> NavigationEnvironment::begin(const EpisodeStart& start, const EpisodeView& out) {
  const FloatMode floats;
  recorder_.reset();
  if (auto placed = place(start); !placed) return placed;
  auto trial = NavigationTrial::create(config_);
  if (!trial) return tl::unexpected<Error>(trial.error());
  trial_.emplace(std::move(*trial));
  if (!file_.empty()) {
    auto recorder = TrialRecorder::create(file_, config_);
    if (!recorder) return tl::unexpected<Error>(recorder.error());
    recorder_.emplace(std::move(*recorder));
    recorder_->begins(trial_->world().state());
    file_.clear();
  }
  pilot_->reset();
  sight_ = {};
  last_action_ = {};
  contacts_ = 0;
  distance_ = goalDistance();
  driven_.assign(1, trial_->world().state().robots.front().pose.position);
  std::fill(out.rewards.begin(), out.rewards.end(), 0.0);
  std::fill(out.terms.begin(), out.terms.end(), 0.0);
  tell(out);
  return {};
}

WheelSpeeds NavigationEnvironment::wheelsFor(const NavigationScene& scene) {
  const RobotModel& robot = *scene.robot;
  const double top_speed = robot.maxSpeed();
  switch (settings_.control) {
    case NavigationControl::kWheels:
      return saturate(robot, {action_[0] * robot.max_wheel_speed, action_[1] * robot.max_wheel_speed});
    case NavigationControl::kTwist:
      return saturate(robot, inverseKinematics(robot, {action_[0] * top_speed,
                                                       action_[1] * 2.0 * top_speed / robot.axle_track}));
    case NavigationControl::kHeading:
      steering_->direction = direction_;
      steering_->speed = top_speed * (action_[1] + 1.0) / 2.0;
      return pilot_->drive(scene);
  }
  return {};
}

Result<EpisodeEnd> NavigationEnvironment::step(std::span<const float> actions, const EpisodeView& out) {
  const FloatMode floats;
  effort_ = near_ = 0.0;
  for (std::size_t i = 0; i < action_.size(); ++i) {
    action_[i] = std::clamp(static_cast<double>(actions[i]), -1.0, 1.0);
    effort_ += std::abs(action_[i] - last_action_[i]) / static_cast<double>(action_.size());
  }
  last_action_ = action_;
  const Vec2 to_goal = scene_->goal.position - scene_->self.pose.position;
  direction_ = math::angleOf(to_goal) + action_[0] * math::kPi;
  const double before = trial_->seconds();
  bool over = false;
  for (int tick = 0; tick < settings_.ticks && !over; ++tick) {
    if (tick > 0) scene_ = &trial_->observe();
    over = !trial_->step(wheelsFor(*scene_));
    if (recorder_) recorder_->ticked(trial_->world().state(), trial_->command(), trial_->hash());
    near_ += nearness() * scene_->dt;
    driven_.push_back(trial_->world().state().robots.front().pose.position);
    if (settings_.ends_at_contact && trial_->spoiled()) break;
  }
  const bool spoiled = settings_.ends_at_contact && trial_->spoiled();
  if ((over || spoiled) && recorder_) {
    TrialResult result;
    result.score = trial_->score();
    result.final_hash = trial_->hash();
    auto written = recorder_->ends(result);
    recorder_.reset();
    if (!written) return tl::unexpected<Error>(written.error());
  }
  const bool late = over && trial_->late();
  reward(trial_->seconds() - before, over || spoiled, out);
  tell(out);
  return EpisodeEnd{spoiled || (over && !late), late && !spoiled};
}

/// How near the robot is to obstacles: 0 from `kNear` on, 1 at a touch.
double NavigationEnvironment::nearness() const {
  const Vec2 at = trial_->world().state().robots.front().pose.position;
  double gap = kNear;
  for (const DiscObstacle& disc : scene_->obstacles) {
    gap = std::min(gap, distance(disc.position, at) - disc.radius - config_.robot.robot.width / 2);
  }
  return 1.0 - std::max(gap, 0.0) / kNear;
}

double NavigationEnvironment::goalDistance() const {
  return distance(trial_->world().state().robots.front().pose.position, config_.layout.goal);
}

void NavigationEnvironment::reward(double seconds, bool over, const EpisodeView& out) {
  const auto pay = [&](NavigationTerm term, double amount) {
    out.terms[static_cast<std::size_t>(term)] = settings_.weights[static_cast<std::size_t>(term)] * amount;
  };
  const TrialScore score = trial_->score();
  const bool success = over && score.arrived && !trial_->spoiled();
  const double distance = goalDistance();
  const int contacts = score.obstacle_contacts + score.wall_contacts;
  pay(NavigationTerm::kSuccess, success ? 1.0 : 0.0);
  pay(NavigationTerm::kFailure, over && !success ? -1.0 : 0.0);
  pay(NavigationTerm::kTime, -seconds / score.time_limit);
  pay(NavigationTerm::kGoal, (distance_ - distance) / score.length_limit);
  pay(NavigationTerm::kContact, contacts_ - contacts);
  pay(NavigationTerm::kClearance, -near_);
  pay(NavigationTerm::kEffort, -effort_);
  distance_ = distance;
  contacts_ = contacts;
  out.rewards[0] = 0.0;
  for (const double term : out.terms) out.rewards[0] += term;
}

void NavigationEnvironment::tell(const EpisodeView& out) {
  scene_ = &trial_->observe();
  sight_.write(*scene_, out.observations);
  const TrialScore score = trial_->score();
  const bool success = score.arrived && !trial_->spoiled();
  out.figures[0] = success ? 1.0 : 0.0;
  out.figures[1] = static_cast<double>(trial_->spoiled() ? TrialOutcome::kCollided : score.outcome);
  out.figures[2] = score.time;
  out.figures[3] = score.timeRatio();
  out.figures[4] = score.length;
  out.figures[5] = score.lengthRatio();
  out.figures[6] = contacts_;
  out.figures[7] = trial_->seconds() > 0.0 ? score.min_clearance : 0.0;
  out.figures[8] = static_cast<double>(config_.index);
}

Result<void> NavigationEnvironment::record(const std::string& file) {
  file_ = file;
  return {};
}

Result<Canvas> NavigationEnvironment::picture(int width) {
  MatchPictureSpec spec;
  spec.width = width;
  spec.field = config_.field;
  spec.robot = config_.robot.robot;
  spec.ball = config_.robot.ball;
  spec.bodies.push_back({BodyKind::kRobot, {}});
  spec.bodies.resize(1 + config_.layout.obstacles.size(), {BodyKind::kObstacle, {}});
  spec.names = {config_.layout.name, fmt::format("{:.2f} s", trial_->seconds())};
  spec.layout = config_.layout;
  const auto drawing = MatchPicture::create(spec);
  if (!drawing) return tl::unexpected<Error>(drawing.error());
  auto canvas = drawing->canvas();
  if (!canvas) return canvas;
  const WorldState& world = trial_->world().state();
  ReplayMoment moment;
  moment.seconds = trial_->seconds();
  moment.tick = world.tick;
  moment.bodies.emplace_back(world.robots.front().pose);
  for (const ObstacleState& obstacle : world.obstacles) moment.bodies.emplace_back(obstacle.pose);
  MatchOverlays overlays;
  overlays.trails.push_back({0, driven_, false, 1.0});
  drawing->drawFrame(*canvas, moment, overlays);
  return canvas;
}

}  // namespace fulbito
