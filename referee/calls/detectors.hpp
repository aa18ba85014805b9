#pragma once

#include <optional>

#include "fulbito/detail/values.hpp"
#include "fulbito/referee.hpp"
#include "referee/calls/calls.hpp"
#include "referee/geometry/areas.hpp"
#include "referee/rules/clauses.hpp"
#include "referee/state/match_view.hpp"

namespace fulbito {

struct RefereeSetup;
struct RefereeState;

/// The input of a detector in one tick of play.
struct DetectorInput {
  const MatchView& view;
  const RefereeSetup& setup;
  const RefereeState& state;
  const AreaReport& areas;
};

/// A reason to stop play.
struct Finding {
  GameEvent event;  ///< complete; for a goal (clause::kGoal), `team` is the scoring team
  RestartKind restart = RestartKind::kKickOff;
  TeamId restart_team = TeamId::kBlue;  ///< the taking team; for a free ball, the team that attacks that half
  Vec2 ball;  ///< [m] position of the ball; for a free ball, the mark of its quarter
};

/// Runs all detectors that the rules enable on one tick of play, in a fixed order of priority: goal (with the
/// fouls that void it), attackers and defenders, keeper charged, keeper holding, holding, push, stuck ball.
/// Not for shoot-out kicks. `memory` must be empty at every restart. Pure: no clock, no randomness, no
/// allocation.
std::optional<Finding> detect(const MatchView& view, const RefereeSetup& setup, const RefereeState& state,
                              DetectorMemory& memory);

/// The same with areas that the caller has counted (reportAreas; hysteresis: `memory.areas`).
std::optional<Finding> detect(const DetectorInput& input, DetectorMemory& memory);

}  // namespace fulbito
