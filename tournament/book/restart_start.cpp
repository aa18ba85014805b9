#include "tournament/book/restart_start.hpp"

#include <array>

#include <fmt/format.h>

#include "referee/restarts/restart_call.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "tournament/book/draw_order.hpp"

namespace fulbito {
namespace {

RestartKind restartOf(StartKind kind) {
  switch (kind) {
    case StartKind::kFreeBall:
      return RestartKind::kFreeBall;
    case StartKind::kPenalty:
      return RestartKind::kPenalty;
    default:
      return RestartKind::kGoalKick;
  }
}

/// Whether the field has the mark that this kind of start puts the ball on.
bool hasMark(StartKind kind, const FieldGeometry& field) {
  if (kind == StartKind::kFreeBall) return field.free_ball_mark.x > 0.0 && field.free_ball_mark.y > 0.0;
  return kind != StartKind::kPenalty || field.penalty_mark > 0.0;
}

Stoppage stoppageOf(const StartKey& key, const FieldGeometry& field) {
  Stoppage stoppage;
  stoppage.kind = restartOf(key.kind);
  if (key.kind == StartKind::kFreeBall) {
    const std::size_t quarter = caseOf(key, 4);
    const Vec2 mark = field.free_ball_mark;
    stoppage.ball = {quarter % 2 == 0 ? mark.x : -mark.x, quarter / 2 == 0 ? mark.y : -mark.y};
  } else {
    stoppage.team = kTeams[caseOf(key, 2)];
  }
  return stoppage;
}

/// Whether every robot of `wanted` has a place in `placed`.
bool allPlaced(const Placement& wanted, const Placement& placed) {
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      if (wanted.robots[indexOf(team)][i] && !placed.robots[indexOf(team)][i]) return false;
    }
  }
  return true;
}

}  // namespace

Result<RestartCall> restartStart(const StartKey& key, const MatchConfig& match) {
  if (!hasMark(key.kind, match.field)) {
    return fail(ErrorCode::kBadInput, fmt::format("start '{}': the field '{}' has no mark for the ball",
                                                  nameOf(key.kind), match.field.name));
  }
  const RefereeSetup setup = refereeSetup(match);
  RestartCall call = makeCall(setup, {}, stoppageOf(key, match.field));
  std::vector<GameEvent> moved;
  const Placement placed = place(setup, {}, call, {}, moved);
  if (!allPlaced(call.defaults, placed)) {
    return fail(ErrorCode::kBadInput,
                fmt::format("start '{}': the field '{}' has no room for {} robots per team at this restart",
                            nameOf(key.kind), match.field.name, match.rules.team_size));
  }
  call.defaults = placed;
  return call;
}

}  // namespace fulbito
