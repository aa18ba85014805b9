#include "match/seats/seat.hpp"

#include <utility>

#include "engine/core/system/stop_request.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

// A team outside the program always has a limit, since it may hang.
std::optional<DecisionTime> limitOf(const MatchConfig& config, TeamId team) {
  if (config.decision_time || !config.teams[indexOf(team)].info->outside) return config.decision_time;
  return config.rules.decision_time;
}

std::optional<Error> cutOf(const Strategy& strategy) {
  const TeamCondition& condition = strategy.condition();
  if (condition.state != TeamCondition::State::kCut) return std::nullopt;
  return Error{stopRequested() ? ErrorCode::kInterrupted : ErrorCode::kMachine, condition.reason};
}

MatchInfo infoOf(const MatchConfig& config, TeamId team, int late) {
  const VisionModel& vision = config.vision[indexOf(team)];
  MatchInfo info;
  info.team = team;
  info.side = team == TeamId::kBlue ? Side::kLeft : Side::kRight;
  info.field = config.field;
  info.robot = config.robot.robot;
  info.ball = config.robot.ball;
  info.physics = config.physics;
  info.rules = config.rules;
  info.observation_age = (vision.latency_ticks + late) * config.physics.controlPeriod();
  info.position_noise = vision.position_noise;
  info.heading_noise = vision.heading_noise;
  info.dropout = vision.dropout;
  info.decision_time = limitOf(config, team);
  info.seed = config.seed * 2 + indexOf(team);
  return info;
}

}  // namespace

Seat::Seat(const MatchConfig& config, TeamId team, int late, const MatchClock& clock,
           std::unique_ptr<Strategy> strategy, TeamPilots pilots, CommandPolicy policy)
    : team_(team),
      latency_ticks_(config.vision[indexOf(team)].latency_ticks + late),
      clock_(clock),
      strategy_(std::move(strategy)),
      pilots_(std::move(pilots)),
      policy_(std::move(policy)) {
  observation_.dt = config.physics.controlPeriod();
  observation_.team_size = config.rules.team_size;
  if (const auto limit = limitOf(config, team)) time_.emplace(*limit);
  const VisionModel& vision = config.vision[indexOf(team)];
  if (!vision.perfect()) vision_.emplace(vision, config.seed, team, observation_.dt);
}

Result<Seat> Seat::create(const MatchConfig& config, TeamId team, const MatchClock& clock, int late) {
  auto strategy = makeTeam(config.teams[indexOf(team)]);
  if (!strategy) return tl::unexpected<Error>(strategy.error());
  const MatchInfo info = infoOf(config, team, late);
  (*strategy)->begin(info);
  if (const auto error = cutOf(**strategy)) return tl::unexpected<Error>(*error);
  const std::span<const NavigatorChoice> navigators = (*strategy)->navigators();
  auto pilots = TeamPilots::create(info, navigators);
  if (!pilots) return tl::unexpected<Error>(pilots.error());
  CommandPolicy policy(team, info, navigators.size());
  return Seat(config, team, late, clock, std::move(*strategy), std::move(*pilots), std::move(policy));
}

void Seat::reset(const Moment& moment) {
  pilots_.reset();
  policy_.reset();
  observation_.sent.fill({});
  if (vision_) vision_->reset(*moment.world);
}

void Seat::allow() {
  if (time_) strategy_->allow(time_->left(observation_.period));
}

// Runs `answer` and charges the team for the time, unless the team measures it itself or has no limit. Once a
// team's condition is bad, its answers do not count, however quick they are.
template <typename Answer>
bool Seat::inTime(const Answer& answer) {
  const bool timed = time_ && clock_;
  const std::int64_t begun_at = timed ? clock_() : 0;
  answer();
  const TeamCondition& condition = strategy_->condition();
  const double measured = timed ? static_cast<double>(clock_() - begun_at) / 1e9 : 0.0;
  const bool late = time_ && time_->late(condition.seconds.value_or(measured), observation_.period);
  return !late && condition.state == TeamCondition::State::kWell;
}

std::optional<TeamProposal> Seat::place(const PlacementRequest& request) {
  allow();
  std::optional<TeamProposal> wishes;
  if (!inTime([&] { wishes = strategy_->place(request); })) wishes.reset();
  return wishes;
}

void Seat::ask() {
  allow();
  strategy_->ask(observation_);
}

void Seat::decide() {
  in_time_ = inTime([&] { decision_ = strategy_->decide(observation_); });
}

void Seat::clean(const GameEvent& now, std::vector<GameEvent>& events) {
  policy_.take(std::move(decision_), !in_time_, strategy_->condition().stands, now, events);
}

std::optional<Error> Seat::cut() const { return cutOf(*strategy_); }

void Seat::fillRobots(const Moment& moment, std::span<const RobotState> robots, Side side,
                      Observation& seen) const {
  const auto size = static_cast<std::size_t>(seen.team_size);
  for (auto* team : {&seen.own, &seen.opponents}) {
    for (std::size_t i = 0; i < size; ++i) (*team)[i].present = false;
  }
  for (std::size_t i = 0; i < moment.ids.size(); ++i) {
    const bool own = moment.ids[i].team == team_;
    ObservedRobot& robot = (own ? seen.own : seen.opponents)[moment.ids[i].number];
    robot.present = true;
    robot.state = inTeamFrame(side, robots[i]);
    if (!own) robot.state.wheels = {};
  }
}

void Seat::fillReferee(const Moment& moment, Observation& seen) const {
  const RefereeState& referee = *moment.referee;
  seen.playing = referee.playing;
  seen.restart = referee.last.kind;
  seen.restart_is_ours = referee.last.team == team_;
  seen.since_restart = static_cast<double>(moment.tick - referee.play_began) * seen.dt;
  seen.period = referee.period;
  seen.overtime_part = referee.period == kOvertimePeriod ? referee.part : 0;
  seen.remaining = static_cast<double>(referee.period_ticks - referee.play_ticks) * seen.dt;
  seen.own_score = referee.score[indexOf(team_)];
  seen.opponent_score = referee.score[indexOf(other(team_))];
  const PerTeam<int>& goals = referee.shoot_out.goals;
  seen.shoot_out_lead = goals[indexOf(team_)] - goals[indexOf(other(team_))];
}

Observation Seat::exactly(const Moment& moment) const {
  const Side side = moment.referee->sideOf(team_);
  Observation seen;
  seen.dt = observation_.dt;
  seen.team_size = observation_.team_size;
  seen.tick = moment.tick;
  if (moment.world != nullptr) {
    fillRobots(moment, moment.world->robots, side, seen);
    seen.ball = inTeamFrame(side, moment.world->balls.front());
    seen.ball.spin = {};
  }
  fillReferee(moment, seen);
  return seen;
}

Observation Seat::before(const RestartCall& call, double delay, const Moment& moment) const {
  Observation seen = exactly(moment);
  seen.playing = false;
  seen.restart = call.kind;
  seen.restart_is_ours = call.team == team_;
  seen.since_restart = -delay;
  return seen;
}

void Seat::drive(std::span<const RobotId> ids, bool held, std::span<WheelSpeeds> commands) {
  const auto wanted = pilots_.drive(observation_, command());
  ways_.clear();
  if (observation_.wants_drawings) pilots_.draw(observation_, command(), ways_);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i].team != team_) continue;
    commands[i] = held ? WheelSpeeds{} : policy_.actuated(wanted[ids[i].number]);
    observation_.sent[ids[i].number] = commands[i];
  }
}

void Seat::sense(const Moment& moment, bool drawings) {
  observation_.wants_drawings = drawings;
  const Side side = moment.referee->sideOf(team_);
  observation_.tick = moment.tick - latency_ticks_;
  if (vision_) {
    const Sight& sight = vision_->see(*moment.world);
    fillRobots(moment, sight.robots, side, observation_);
    observation_.ball = inTeamFrame(side, sight.ball);
  } else {
    fillRobots(moment, moment.world->robots, side, observation_);
    observation_.ball = inTeamFrame(side, moment.world->balls.front());
  }
  observation_.ball.spin = {};
  fillReferee(moment, observation_);
}

}  // namespace fulbito
