#include "bridge/wire/wire_team.hpp"

#include <algorithm>
#include <utility>

#include "bridge/wire/referee_words.hpp"
#include "engine/core/system/stop_request.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/referee.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito::wire {
namespace {

void show(const std::array<ObservedRobot, kMaxTeamSize>& robots, int size, Side side,
          std::vector<SeenRobot>& out) {
  for (int i = 0; i < size; ++i) {
    const ObservedRobot& robot = robots[static_cast<std::size_t>(i)];
    if (!robot.present) continue;
    out.push_back({static_cast<std::uint32_t>(i), inTeamFrame(side, robot.state)});
    out.back().state.wheels = {};
  }
}

/// Robots at these places, at rest. Those without a place keep theirs.
void standAt(const TeamPlacement& places, std::array<ObservedRobot, kMaxTeamSize>& robots) {
  for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
    if (places[i]) robots[i] = {true, {*places[i], {}, 0.0, {}}};
  }
}

bool anyPresent(const std::array<ObservedRobot, kMaxTeamSize>& robots) {
  return std::any_of(robots.begin(), robots.end(), [](const ObservedRobot& robot) { return robot.present; });
}

TeamPlacement turned(const TeamPlacement& places) {
  TeamPlacement result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i]) result[i] = inTeamFrame(Side::kRight, *places[i]);
  }
  return result;
}

}  // namespace

WireTeam::WireTeam(std::shared_ptr<WireServer> server, TeamId colour, bool awaits)
    : server_(std::move(server)),
      colour_(colour),
      awaits_(awaits),
      side_(colour == TeamId::kBlue ? Side::kLeft : Side::kRight) {}

void WireTeam::begin(const MatchInfo& info) {
  info_ = info;
  condition_ = {};
  condition_.stands = true;  // as on the league's simulator
  condition_.seconds = 0.0;  // time passes by the wire's clock, and is not the team's
  server_->begin(info.rules.team_size, info.dt());
}

void WireTeam::lose(const char* reason) {
  condition_.state = TeamCondition::State::kLost;
  condition_.failures = 1;
  condition_.reason = reason;
}

Vision WireTeam::visionOf(const Observation& observation) const {
  Vision vision;
  vision.field = info_.field;
  vision.ball = inTeamFrame(side_, observation.ball);
  vision.ball_height = info_.ball.radius;
  show(observation.own, observation.team_size, side_, vision.robots[indexOf(colour_)]);
  show(observation.opponents, observation.team_size, side_, vision.robots[indexOf(other(colour_))]);
  vision.goals[indexOf(colour_)] = static_cast<std::uint32_t>(std::max(observation.own_score, 0));
  vision.goals[indexOf(other(colour_))] = static_cast<std::uint32_t>(std::max(observation.opponent_score, 0));
  return vision;
}

/// While play is stopped the robots are where they were, at rest. Before the first placement they are where
/// the rules would place them.
Vision WireTeam::restingVision(const PlacementRequest& request) const {
  Observation now = request.now;
  if (!anyPresent(now.own) && !anyPresent(now.opponents)) {
    now.team_size = info_.rules.team_size;
    standAt(request.defaults, now.own);
    standAt(request.opponents.value_or(turned(request.defaults)), now.opponents);
    now.ball.position = request.ball;
  }
  for (auto* robots : {&now.own, &now.opponents}) {
    for (ObservedRobot& robot : *robots) {
      robot.state.velocity = {};
      robot.state.angular_velocity = 0.0;
    }
  }
  now.ball.velocity = {};
  return visionOf(now);
}

RefereeCommand WireTeam::commandOf(Foul foul, const Observation& observation) const {
  RefereeCommand command;
  command.foul = foul;
  command.half = halfOf(observation.period, observation.overtime_part);
  command.seconds = std::max(0.0, periodSeconds(info_.rules, observation.period) - observation.remaining);
  return command;
}

RefereeCommand WireTeam::foulOf(const PlacementRequest& request) const {
  RefereeCommand command = commandOf(wire::foulOf(request.kind), request.now);
  if (request.kind == RestartKind::kFreeBall) {
    command.quadrant = quadrantOf(inTeamFrame(side_, request.ball));
  } else if (request.kind != RestartKind::kGiven) {
    command.team = request.ours ? colour_ : other(colour_);
  }
  return command;
}

std::optional<TeamProposal> WireTeam::place(const PlacementRequest& request) {
  if (lost()) return std::nullopt;
  const RefereeCommand foul = foulOf(request);
  const Vision vision = restingVision(request);
  if (!awaitClient(foul, vision)) return std::nullopt;
  const auto places = server_->awaitPlaces(colour_, foul, vision);
  if (!places) return std::nullopt;
  TeamProposal proposal;
  for (const PlacedRobot& robot : places->robots) {
    const Pose2 pose{robot.pose.position, math::wrapAngle(robot.pose.heading)};
    proposal.robots[robot.number] = inTeamFrame(side_, pose);
  }
  return proposal;
}

bool WireTeam::awaitClient(const RefereeCommand& command, const Vision& vision) {
  awaits_ = false;
  const bool came = server_->awaitClient(colour_, command, vision);
  if (!came && server_->silent(colour_)) lose("no client came");
  return came;
}

void WireTeam::ready(const Observation& observation) {
  if (lost()) return;
  const RefereeCommand stop = commandOf(Foul::kStop, observation);
  awaitClient(stop, visionOf(observation));
  if (!lost()) server_->say(stop);
}

void WireTeam::ask(const Observation& observation) {
  // A match that begins with play, as drills do, has no restart before it.
  if (awaits_ && !lost()) awaitClient(commandOf(Foul::kStop, observation), visionOf(observation));
  server_->say(commandOf(observation.playing ? Foul::kGameOn : Foul::kStop, observation));
  server_->showTick(observation.tick, visionOf(observation));
}

TeamCommand WireTeam::decide(const Observation& observation) {
  TeamCommand command;
  if (lost()) return command;
  std::uint32_t present = 0;
  for (std::size_t i = 0; i < kMaxTeamSize; ++i) present |= (observation.own[i].present ? 1U : 0U) << i;
  condition_.state = TeamCondition::State::kWell;
  if (server_->settings().lockstep) {
    // Clients may be silent until the signal, and that is not late.
    const double limit = observation.playing ? server_->settings().answer : info_.dt();
    const bool answered = server_->awaitCommands(colour_, present, limit);
    // After a request to stop nobody waits any more.
    if (!answered && observation.playing && !stopRequested()) condition_.state = TeamCondition::State::kLate;
  } else {
    server_->finishFrame();
  }
  if (server_->silent(colour_)) lose("its client has said nothing for too long");
  for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
    command.robots[i] = RobotCommand::byWheels(server_->wheels(colour_, i));
  }
  return command;
}

void WireTeam::ended(const MatchEnd&) { server_->sayHalt(RefereeCommand{}); }

}  // namespace fulbito::wire
