#include "apps/league/heard_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/league/heard_events.hpp"
#include "bridge/wire/referee_words.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/recorder.hpp"
#include "replays/chunks/heard_state.hpp"

namespace fulbito::app {
namespace {

using wire::Foul;
using wire::Half;

// Finer than any difference between simulators that a reader could want to see.
constexpr double kStep = 1e-6;     // [m]
constexpr int kTurn = 1'000'000;   // steps
constexpr double kFarthest = 100;  // [m] farther away no body can be

constexpr double kSilence = 1.0;          // [s] without the first server until another one counts
constexpr std::int64_t kLateMost = 1000;  // [ms] that frames may be out of order; more: the server began anew
constexpr std::int64_t kLostMost = 300'000;  // [ms] that vision may lack; more: the server began anew
// Readers refuse more than 20,000 events in a small file.
constexpr std::int64_t kMostMarks = 19'000;
constexpr int kMostGoals = 1'000'000;
constexpr double kLongestPeriod = 86'400.0;  // [s]

RecordingHeader headerOf(const MatchConfig& config) {
  RecordingHeader header = recordingHeader(config, RecordingLevel::kFull);
  header.heard = true;
  header.sample_every = 1;
  header.sample_step = kStep;
  header.sample_turn = kTurn;
  header.recipe.seed = 0;
  header.recipe.more.clear();
  return header;
}

bool possible(const wire::SeenWorld& seen) {
  const auto within = [](Vec2 p) { return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest; };
  return within(seen.ball.position) &&
         std::all_of(seen.robots.begin(), seen.robots.end(),
                     [&](const RobotState& robot) { return within(robot.pose.position); });
}

Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.position + (b.position - a.position) * share,
          math::wrapAngle(a.heading + math::wrapAngle(b.heading - a.heading) * share)};
}

PerTeam<int> goalsOf(const wire::Vision& vision) {
  PerTeam<int> goals{};
  for (std::size_t i = 0; i < goals.size(); ++i) {
    goals[i] = static_cast<int>(std::min<std::uint32_t>(vision.goals[i], kMostGoals));
  }
  return goals;
}

}  // namespace

HeardRecorder::HeardRecorder(const MatchConfig& config, Open open)
    : header_(headerOf(config)),
      field_(config.field),
      rules_(config.rules.name),
      team_size_(config.rules.team_size),
      open_(std::move(open)),
      poses_(header_.bodies.size()) {}

double HeardRecorder::seconds() const {
  return writer_ ? static_cast<double>(writer_->tick()) / header_.control_rate : 0.0;
}

void HeardRecorder::mark(std::string_view clause, std::optional<TeamId> team, double value) {
  if (marks_++ >= kMostMarks) return;
  RecordedEvent event;
  event.tick = writer_ ? writer_->tick() : 0;
  event.play_time = static_cast<double>(play_ticks_) / header_.control_rate;
  event.period = static_cast<std::uint8_t>(wire::periodOf(half_));
  event.clause = clause;
  event.team = team;
  if (poses_.back()) event.place = poses_.back()->position;
  event.value = value;
  if (writer_) {
    writer_->add(event);
  } else {
    early_.push_back(std::move(event));
  }
}

void HeardRecorder::beginHalf(Half half) {
  if (half == Half::kNone || half == half_) return;
  const bool first = half_ == Half::kNone;
  if (!first && half == Half::kSecond) mark("half", {}, 0.0);
  half_ = half;
  if (!first) play_ticks_ = 0;
  const bool overtime = half == Half::kOvertimeFirst || half == Half::kOvertimeSecond;
  if (overtime) mark("overtime", {}, wire::overtimePartOf(half));
}

void HeardRecorder::take(const wire::RefereeCommand& command) {
  if (told_ && wire::sameCommand(*told_, command)) return;
  told_ = command;
  ++counts_.commands;
  beginHalf(command.half);
  if (command.seconds > 0.0 && command.seconds < kLongestPeriod) {
    play_ticks_ = std::max<Tick>(play_ticks_, std::lround(command.seconds * header_.control_rate));
  }
  mark(kToldEvents[static_cast<std::size_t>(command.foul)], command.team, command.quadrant);
  playing_ = command.foul == Foul::kGameOn;
  played_ = played_ || playing_;
  if (wire::isRestart(command.foul)) {
    restart_ = command;
  } else if (restart_ && command.foul != Foul::kHalt) {
    due_ = true;
  }
}

Result<void> HeardRecorder::begin(const wire::Vision& vision) {
  if (auto same = wire::checkField(vision, field_, rules_); !same) return same;
  auto writer = open_(header_);
  if (!writer) return tl::unexpected<Error>(writer.error());
  writer_.emplace(std::move(*writer));
  score_ = goalsOf(vision);
  return {};
}

/// The ticks since the last frame; 0: the frame is late. False: the server has begun anew.
Result<bool> HeardRecorder::passes(std::uint32_t step, Tick& passed) {
  const std::int64_t difference = std::int64_t{step} - std::int64_t{step_};
  if (difference < -kLateMost || difference > kLostMost) return false;
  if (difference <= 0) {
    passed = 0;
    return true;
  }
  const double frames = static_cast<double>(difference) / frameMilliseconds(header_.control_rate);
  passed = std::max<Tick>(1, std::lround(frames));
  return true;
}

HeardRecorder::Poses HeardRecorder::posesOf(const wire::SeenWorld& seen) const {
  Poses poses(header_.bodies.size());
  std::size_t next = 0;
  for (std::size_t body = 0; body < poses.size(); ++body) {
    if (header_.bodies[body].kind == BodyKind::kBall) {
      poses[body] = asSampled(header_, {seen.ball.position, 0.0});
    } else if (next < seen.ids.size() && header_.bodies[body].id == seen.ids[next]) {
      poses[body] = asSampled(header_, seen.robots[next++].pose);
    }
  }
  return poses;
}

Result<bool> HeardRecorder::see(const wire::Vision& vision, std::uint64_t sender, double now) {
  if (sender_ && sender != *sender_) {
    if (now - heard_at_ > kSilence) return false;
    ++counts_.strangers;
    return true;
  }
  const auto seen = wire::seenWorld(vision, team_size_);
  if (!seen || !possible(*seen)) {
    ++counts_.odd;
    return true;
  }
  Tick passed = 1;
  if (writer_) {
    const auto same = passes(vision.step, passed);
    if (!same || !*same) return same;
  } else if (auto begun = begin(vision); !begun) {
    return tl::unexpected<Error>(begun.error());
  }
  sender_ = sender;
  heard_at_ = now;
  if (passed == 0) {
    ++counts_.late;
    return true;
  }
  step_ = vision.step;
  counts_.unknown += seen->unknown;
  record(posesOf(*seen), goalsOf(vision), passed - 1);
  return true;
}

void HeardRecorder::record(const Poses& poses, const PerTeam<int>& goals, Tick lost) {
  ++counts_.frames;
  if (lost > 0) fillGap(poses, lost);
  const bool same_bodies =
      std::equal(poses.begin(), poses.end(), poses_.begin(),
                 [](const auto& a, const auto& b) { return a.has_value() == b.has_value(); });
  const bool one_by_one = std::equal(goals.begin(), goals.end(), score_.begin(),
                                     [](int now, int before) { return now == before || now == before + 1; });
  if (!one_by_one) score_ = goals;
  if (due_ || !same_bodies || !one_by_one) {
    countGoals(goals);  // the play begins with them
    beginPlay(poses);
  }
  addTick(poses);
  if (lost > 0) mark(kVisionLost, {}, static_cast<double>(lost));
  countGoals(goals);
}

/// So that every frame has its tick, bodies move straight on from where they were.
void HeardRecorder::fillGap(const Poses& next, Tick lost) {
  ++counts_.gaps;
  counts_.lost += lost;
  const Poses before = poses_;
  Poses poses = before;
  for (Tick i = 1; i <= lost; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(lost + 1);
    for (std::size_t body = 0; body < poses.size(); ++body) {
      if (before[body] && next[body]) {
        poses[body] = asSampled(header_, between(*before[body], *next[body], share));
      }
    }
    addTick(poses);
  }
}

void HeardRecorder::beginPlay(const Poses& poses) {
  RecordedPlay play;
  if (due_ && restart_) {
    play.kind = wire::restartOf(restart_->foul);
    play.team = restart_->team.value_or(TeamId::kBlue);
    restart_.reset();
  }
  due_ = false;
  play.ball = poses.back()->position;
  play.delay = playing_ ? 0 : 1;
  play.period = wire::periodOf(half_);
  play.play_ticks = play_ticks_;
  play.score = score_;
  play.hash = hash_.value();
  bodies_.clear();
  for (std::size_t body = 0; body < poses.size(); ++body) {
    play.starts.push_back({poses[body].has_value(), poses[body].value_or(Pose2{}), {}, 0.0, {}});
    if (poses[body]) bodies_.push_back(body);
  }
  state_ = {};
  writer_->beginPlay(play);
  for (const RecordedEvent& event : std::exchange(early_, {})) writer_->add(event);
}

void HeardRecorder::addTick(const Poses& poses) {
  std::vector<Pose2> places;
  places.reserve(poses.size());
  for (const auto& pose : poses) places.push_back(pose.value_or(Pose2{}));
  standAt(header_, places, bodies_, state_);
  hash_.add(state_);
  const std::vector<WheelSpeeds> commands(state_.robots.size());
  writer_->add(RecordingTick{&state_, commands, hash_.value(), playing_});
  play_ticks_ += playing_ ? 1 : 0;
  poses_ = poses;
}

void HeardRecorder::countGoals(const PerTeam<int>& goals) {
  for (const TeamId team : kTeams) {
    int& own = score_[indexOf(team)];
    if (goals[indexOf(team)] == own) continue;
    own = goals[indexOf(team)];
    mark("goal", team, 0.0);
  }
}

Result<void> HeardRecorder::finish() {
  RecordingResult result;
  result.complete = halted();
  result.score = score_;
  result.final_hash = hash_.value();
  if (result.complete) {
    result.outcome =
        score_[0] == score_[1] ? "draw" : nameOf(score_[0] > score_[1] ? TeamId::kBlue : TeamId::kYellow);
  }
  result.figures = {{"frames", static_cast<double>(counts_.frames)},
                    {"gaps", static_cast<double>(counts_.gaps)},
                    {"lost", static_cast<double>(counts_.lost)},
                    {"late", static_cast<double>(counts_.late)}};
  return writer_->finish(result);
}

}  // namespace fulbito::app
