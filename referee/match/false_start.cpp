#include "referee/match/false_start.hpp"

#include "referee/restarts/restart_call.hpp"
#include "referee/state/ticks.hpp"

namespace fulbito {
namespace {

/// The same restart again, without robots sent off meanwhile.
RestartCall repeated(const RefereeSetup& setup, const RefereeState& state) {
  RestartCall call = state.last;
  for (const TeamId team : kTeams) {
    for (int n = 0; n < kMaxTeamSize; ++n) {
      if (!fielded(setup, state, team, n))
        call.defaults.robots[indexOf(team)][static_cast<std::size_t>(n)].reset();
    }
  }
  return call;
}

RestartCall afterKickOff(const RefereeSetup& setup, RefereeState& state, TeamId team, int beyond,
                         const MatchView& view) {
  const TeamId rival = other(team);
  const auto call = [&](RestartKind kind, TeamId to) {
    return makeCall(setup, state, {kind, to, view.ball.position, &view});
  };
  if (beyond >= 2) return call(RestartKind::kFreeKick, rival);
  if (team == state.last.team) return call(RestartKind::kKickOff, rival);
  RestartCall again = repeated(setup, state);
  again.defenders_back = true;
  return again;
}

/// The keeper or defender that moved gets a yellow card; from the second such false start on, it is sent off.
RestartCall cardAtPenalty(const RefereeSetup& setup, RefereeState& state, RobotId robot, int beyond) {
  RobotRecord& record = state.robots[indexOf(robot.team)][robot.number];
  ++record.cards;
  if (beyond >= 2) {
    record.out = true;
    record.back_after = state.match_ticks + ticksOf(setup.rules.restart.card_seconds, setup.dt);
  }
  return repeated(setup, state);
}

}  // namespace

std::optional<FalseStart> observeFalseStart(const RefereeSetup& setup, const MatchView& view,
                                            const RefereeState& before, Tick& away_ticks, TeamId toss) {
  const RestartRules& rules = setup.rules.restart;
  FalseStart farthest;
  for (std::size_t i = 0; i < view.ids.size(); ++i) {
    const RobotId id = view.ids[i];
    const auto& place = before.placed.robots[indexOf(id.team)][id.number];
    if (!place) continue;
    const double moved = distance(view.robots[i].pose.position, place->position);
    const bool even = moved == farthest.moved && id.team != farthest.robot.team && id.team == toss;
    if (moved > farthest.moved || even) farthest = {id, moved};
  }
  // Once a robot is away, it must come clearly back to stop the count.
  const double limit = away_ticks > 0 ? rules.false_start_release : rules.false_start_distance;
  away_ticks = farthest.moved > limit ? away_ticks + 1 : 0;
  if (away_ticks == 0 || away_ticks < ticksOf(rules.false_start_seconds, setup.dt)) return std::nullopt;
  return farthest;
}

RestartCall punish(const RefereeSetup& setup, RefereeState& state, const FalseStart& fault,
                   const MatchView& view) {
  const TeamId team = fault.robot.team;
  const TeamId rival = other(team);
  const int beyond = state.false_starts[indexOf(team)] - setup.rules.restart.warnings;
  const bool takes = team == state.last.team;
  const auto call = [&](RestartKind kind, TeamId to) {
    return makeCall(setup, state, {kind, to, view.ball.position, &view});
  };
  if (beyond <= 0 || !setup.rules.restart.escalation || state.period == kShootOutPeriod) {
    return repeated(setup, state);
  }
  switch (state.last.kind) {
    case RestartKind::kKickOff:
      return afterKickOff(setup, state, team, beyond, view);
    case RestartKind::kPenalty:
      return takes ? call(RestartKind::kFreeBall, team) : cardAtPenalty(setup, state, fault.robot, beyond);
    case RestartKind::kFreeKick:
      return takes ? call(RestartKind::kFreeKick, rival) : call(RestartKind::kPenalty, rival);
    case RestartKind::kFreeBall:
    case RestartKind::kGoalKick:  // the law does not mention goal kicks
      return call(RestartKind::kFreeKick, rival);
    case RestartKind::kGiven:
      break;
  }
  return repeated(setup, state);
}

}  // namespace fulbito
