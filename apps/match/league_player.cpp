#include "apps/match/league_player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/wire/referee_words.hpp"
#include "bridge/wire/seen_world.hpp"
#include "referee/restarts/restart_call.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito::app {
namespace {

using wire::Foul;

/// A point in the quadrant, counter-clockwise from x > 0, y > 0; without one the point itself.
Vec2 inQuadrant(int quadrant, Vec2 point) {
  if (quadrant == 0) return point;
  const bool right = quadrant == 1 || quadrant == 4, upper = quadrant <= 2;
  return {right ? std::abs(point.x) : -std::abs(point.x), upper ? std::abs(point.y) : -std::abs(point.y)};
}

/// What encoders would show, from the motion over ground.
WheelSpeeds wheelsOf(const RobotModel& model, const RobotState& robot) {
  const double forward = dot(robot.velocity, math::unit(robot.pose.heading));
  const double turn = robot.angular_velocity * model.axle_track / 2;
  return {(forward - turn) / model.wheel_radius, (forward + turn) / model.wheel_radius};
}

}  // namespace

LeaguePlayer::LeaguePlayer(const MatchConfig& config, TeamId team, Seat&& seat)
    : config_(config), setup_(refereeSetup(config)), team_(team), seat_(std::move(seat)) {
  world_.balls.resize(1);
  state_.last.kind = RestartKind::kGiven;  // until a foul is heard
  beginPeriod(wire::Half::kFirst);
}

Result<LeaguePlayer> LeaguePlayer::create(const MatchConfig& config, TeamId team, const MatchClock& clock) {
  // Its commands act later, but the frame is fresh: nothing delays it once more.
  MatchConfig seen = config;
  const int late = std::exchange(seen.vision[indexOf(team)].latency_ticks, 0);
  auto seat = Seat::create(seen, team, clock, late);
  if (!seat) return tl::unexpected<Error>(seat.error());
  return LeaguePlayer(config, team, std::move(*seat));
}

double LeaguePlayer::playSeconds() const {
  return static_cast<double>(state_.match_ticks) * config_.physics.controlPeriod();
}

void LeaguePlayer::beginPeriod(wire::Half half) {
  state_.period = wire::periodOf(half);
  state_.part = wire::overtimePartOf(half);
  state_.play_ticks = 0;
  const double seconds = periodSeconds(config_.rules, state_.period);
  state_.period_ticks = static_cast<Tick>(std::lround(seconds / config_.physics.controlPeriod()));
}

std::optional<wire::TeamPlaces> LeaguePlayer::take(const wire::RefereeCommand& command) {
  if (told_ && sameCommand(*told_, command)) return wire::isRestart(command.foul) ? placement_ : std::nullopt;
  if (!told_ || told_->half != command.half) beginPeriod(command.half);
  const bool was_playing = state_.playing;
  told_ = command;
  state_.playing = command.foul == Foul::kGameOn;
  if (state_.playing) {
    played_ = true;
    state_.play_began = tick_;
    return std::nullopt;
  }
  placement_.reset();
  if (!wire::isRestart(command.foul)) return std::nullopt;
  ready_ = false;
  if (was_playing) seat_.strategy().stopped({GameEvent{}, seat_.exactly(moment())});
  placement_ = place(command);
  return placement_;
}

wire::TeamPlaces LeaguePlayer::place(const wire::RefereeCommand& command) {
  const Side side = state_.sideOf(team_);
  const MatchView view{tick_, ids_, world_.robots, world_.balls.front(), {}};
  Stoppage stoppage;
  stoppage.kind = wire::restartOf(command.foul);
  stoppage.team = command.team.value_or(team_);
  stoppage.ball = inQuadrant(command.quadrant, world_.balls.front().position);
  stoppage.view = ids_.empty() ? nullptr : &view;
  const RestartCall call = makeCall(setup_, state_, stoppage);
  state_.last = call;
  PlacementRequest request;
  request.kind = call.kind;
  request.ours = call.team == team_;
  request.ball = inTeamFrame(side, call.ball);
  for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
    const auto& pose = defaultPoses(call, team_)[i];
    if (pose) request.defaults[i] = inTeamFrame(side, *pose);
  }
  request.delay = static_cast<double>(call.delay) * setup_.dt;
  request.now = seat_.before(call, request.delay, moment());
  Proposals proposals;
  if (const auto wishes = seat_.place(request)) {
    TeamPoses& poses = proposals[indexOf(team_)].emplace();
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      if (wishes->robots[i]) poses[i] = inTeamFrame(side, *wishes->robots[i]);
    }
  }
  // Repaired here: the league's referee stops for a human otherwise.
  std::vector<GameEvent> repairs;
  state_.placed = fulbito::place(setup_, state_, call, proposals, repairs);
  ++counts_.placements;
  wire::TeamPlaces places{team_, {}};
  for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
    const auto& pose = state_.placed.robots[indexOf(team_)][i];
    if (pose) places.robots.push_back({static_cast<std::uint32_t>(i), *pose});
  }
  return places;
}

bool LeaguePlayer::see(const wire::Vision& vision) {
  auto seen = wire::seenWorld(vision, config_.rules.team_size);
  if (!seen) return false;
  for (RobotState& robot : seen->robots) robot.wheels = wheelsOf(config_.robot.robot, robot);
  world_.robots = std::move(seen->robots);
  world_.balls = {seen->ball};
  ids_ = std::move(seen->ids);
  state_.score = {static_cast<int>(vision.goals[0]), static_cast<int>(vision.goals[1])};
  return true;
}

/// Frames that were lost or skipped count too. A server that begins anew starts again at 0.
void LeaguePlayer::advance(std::uint32_t step) {
  Tick passed = 1;
  if (step_ && step > *step_) {
    passed = std::max<Tick>(1, std::lround((step - *step_) * 1e-3 / config_.physics.controlPeriod()));
  }
  step_ = step;
  tick_ += passed;
  if (!state_.playing) return;
  state_.play_ticks += passed;
  state_.match_ticks += passed;
}

Result<wire::Packet> LeaguePlayer::play(const wire::Vision& vision) {
  if (auto same = wire::checkField(vision, config_.field, config_.rules.name); !same) {
    return tl::unexpected<Error>(same.error());
  }
  if (!see(vision)) {
    ++counts_.odd;
    return wire::Packet{};
  }
  ++counts_.frames;
  advance(vision.step);
  wire::Packet packet = decide();
  if (const auto error = seat_.cut()) return tl::unexpected<Error>(*error);
  if (seat_.lost()) return fail(ErrorCode::kBadInput, "the team failed too often: " + faults().failure);
  return packet;
}

wire::Packet LeaguePlayer::decide() {
  const bool placed = told_ && (told_->foul == Foul::kStop || told_->foul == Foul::kGameOn);
  if (placed && !ready_) {
    ready_ = true;
    seat_.reset(moment());
    seat_.strategy().ready(seat_.exactly(moment()));
  }
  std::vector<WheelSpeeds> wheels(ids_.size());
  if (placed) {
    std::vector<GameEvent> events;
    seat_.sense(moment(config_.vision[indexOf(team_)].latency_ticks), false);
    seat_.ask();
    seat_.decide();
    seat_.clean({}, events);
    seat_.countFailures({}, events);
    seat_.drive(ids_, !state_.playing, wheels);
  }
  wire::Packet packet;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (ids_[i].team == team_) packet.commands.push_back({ids_[i].number, team_, wheels[i]});
  }
  return packet;
}

void LeaguePlayer::end() {
  MatchEnd told;
  told.reason = halted() ? MatchEnd::Reason::kPlayed : MatchEnd::Reason::kInterrupted;
  told.tick = tick_;
  told.own_score = state_.score[indexOf(team_)];
  told.opponent_score = state_.score[indexOf(other(team_))];
  seat_.strategy().ended(told);
}

}  // namespace fulbito::app
