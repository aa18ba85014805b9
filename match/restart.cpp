#include "match/restart.hpp"

#include "engine/core/math.hpp"
#include "strategies/team_frame.hpp"

namespace fulbito {
namespace {

TeamPlacement inTeamFrame(Side side, const TeamPlacement& poses) {
  TeamPlacement turned;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i]) turned[i] = inTeamFrame(side, *poses[i]);
  }
  return turned;
}

// The proposal in the world's frame: the default where the team proposes nothing, and nobody where the rule
// has nobody.
TeamPlacement proposed(const PlacementRequest& request, Side side, Strategy& team) {
  TeamPlacement wanted = request.defaults;
  if (const auto proposal = team.place(request)) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] && (*proposal)[i]) wanted[i] = (*proposal)[i];
    }
  }
  return inTeamFrame(side, wanted);
}

}  // namespace

Placement placementOf(const RestartCall& call, const MatchReferee& referee, PerTeam<Strategy*> teams,
                      std::vector<GameEvent>&) {
  Placement placement = call.defaults;
  std::optional<TeamPlacement> first;
  for (const TeamId team : {call.team, other(call.team)}) {
    const Side blue = referee.state().blue_side;
    const Side side = team == TeamId::kBlue ? blue : opposite(blue);
    PlacementRequest request;
    request.kind = call.kind;
    request.ours = team == call.team;
    request.ball = inTeamFrame(side, call.defaults.ball);
    request.defaults = inTeamFrame(side, call.defaults.robots[indexOf(team)]);
    if (first) request.opponents = inTeamFrame(side, *first);
    placement.robots[indexOf(team)] = proposed(request, side, *teams[indexOf(team)]);
    first = placement.robots[indexOf(team)];
  }
  return placement;
}

void misplace(Placement& placement, const PlacementError& error, Rng& random) {
  for (auto& team : placement.robots) {
    for (std::optional<Pose2>& pose : team) {
      if (!pose) continue;
      pose->position += {random.uniform(-error.position, error.position),
                         random.uniform(-error.position, error.position)};
      pose->heading = math::wrapAngle(pose->heading + random.uniform(-error.heading, error.heading));
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
  setup.balls.push_back({config.robot.ball, placement.ball, placement.ball_velocity, {}});
  auto world = World::create(setup);
  if (!world) return tl::unexpected<Error>(world.error());
  return Play{call, placement, std::move(ids), std::move(*world), {}};
}

}  // namespace fulbito
