#include "match/play/restart.hpp"

#include "fulbito/detail/math.hpp"
#include "referee/restarts/goal_kick_ball.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

TeamPlacement inTeamFrame(Side side, const TeamPlacement& poses) {
  TeamPlacement turned;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i]) turned[i] = inTeamFrame(side, *poses[i]);
  }
  return turned;
}

}  // namespace

std::optional<TeamId> Placing::asked() const {
  if (answers_ == kTeams.size()) return std::nullopt;
  return answers_ == 0 ? first_ : other(first_);
}

PlacementRequest Placing::request(const MatchReferee& referee) const {
  const TeamId team = asked().value_or(first_);
  const Side side = referee.state().sideOf(team);
  PlacementRequest request;
  request.kind = call_.kind;
  request.ours = team == call_.team;
  request.ball = inTeamFrame(side, call_.ball);
  request.defaults = inTeamFrame(side, defaultPoses(call_, team));
  if (!request.ours) {
    // The second team sees where the first team will stand after the repairs.
    std::vector<GameEvent> told_again_later;
    const Placement placement = legalised(referee, told_again_later);
    request.opponents = inTeamFrame(side, placement.robots[indexOf(first_)]);
  }
  request.cause = inTeamFrame(side, cause_);
  request.delay = delay(referee);
  return request;
}

double Placing::delay(const MatchReferee& referee) const {
  return static_cast<double>(referee.delayOf(call_)) * referee.setup().dt;
}

void Placing::answer(const std::optional<TeamProposal>& proposal, const MatchReferee& referee) {
  const auto team = asked();
  if (!team) return;
  ++answers_;
  if (!proposal) return;
  const Side side = referee.state().sideOf(*team);
  proposals_[indexOf(*team)] = inTeamFrame(side, proposal->robots);
  if (*team != call_.team || !proposal->ball) return;
  call_ = withBall(referee.setup(), referee.state(), call_, inTeamFrame(side, *proposal->ball), repairs_);
}

Placement Placing::legalised(const MatchReferee& referee, std::vector<GameEvent>& events) const {
  events.insert(events.end(), repairs_.begin(), repairs_.end());
  return place(referee.setup(), referee.state(), call_, proposals_, events);
}

void misplace(Placement& placement, const RestartCall& call, const MatchReferee& referee,
              const PlacementError& error, Rng& random) {
  for (const TeamId team : kTeams) {
    for (std::size_t n = 0; n < kMaxTeamSize; ++n) {
      std::optional<Pose2>& pose = placement.robots[indexOf(team)][n];
      if (!pose || restsInPlace(call, {team, static_cast<std::uint8_t>(n)}, *pose)) continue;
      const Pose2 exact = *pose;
      pose->position.x += random.uniform(-error.position, error.position);
      pose->position.y += random.uniform(-error.position, error.position);
      pose->heading = math::wrapAngle(pose->heading + random.uniform(-error.heading, error.heading));
      if (!legalPlacement(referee.setup(), referee.state(), call, placement)) pose = exact;
    }
  }
}

Result<Play> makePlay(const MatchConfig& config, const RestartCall& call, const Placement& placement) {
  WorldConfig setup;
  setup.field = config.field;
  setup.physics = config.physics;
  std::vector<RobotId> ids;
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(config.rules.team_size); ++i) {
      const auto& pose = placement.robots[indexOf(team)][i];
      if (!pose) continue;
      ids.push_back({team, static_cast<std::uint8_t>(i)});
      setup.robots.push_back({config.robot.robot, *pose, {}, 0.0});
    }
  }
  setup.balls.push_back(
      {config.robot.ball, placement.ball, placement.ball_velocity, placement.ball_velocity});
  auto world = World::create(setup);
  if (!world) return tl::unexpected<Error>(world.error());
  return Play{call, placement, std::move(ids), std::move(*world), {}};
}

}  // namespace fulbito
