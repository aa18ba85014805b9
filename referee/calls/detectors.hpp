#pragma once

#include <optional>

#include "engine/core/base/restart_kind.hpp"
#include "referee/calls/detector_memory.hpp"
#include "referee/geometry/areas.hpp"
#include "referee/rules/clauses.hpp"
#include "referee/state/game_event.hpp"
#include "referee/state/match_view.hpp"

namespace fulbito {

struct RefereeSetup;
struct RefereeState;

/// What a detector looks at in one tick of play.
struct DetectorInput {
  const MatchView& view;
  const RefereeSetup& setup;
  const RefereeState& state;
  const AreaReport& areas;
};

/// What stops play.
struct Finding {
  GameEvent event;  ///< complete; of a goal (clause::kGoal) `team` is who scored
  RestartKind restart = RestartKind::kKickOff;
  TeamId restart_team = TeamId::kBlue;  ///< who takes it; of a free ball: who attacks that half
  Vec2 ball;  ///< [m] of a free ball the mark of its quarter, of all else where the ball was
};

/// Looks at one tick of play with every detector that the rules switch on, in a fixed order of priority:
/// goal (with the fouls that void it), attackers and defenders, keeper charged, keeper holding, holding,
/// push, stuck ball. Not for the kicks of a shoot-out. `memory` starts empty at every restart. Pure: no
/// clock, no randomness, no allocation.
std::optional<Finding> detect(const MatchView& view, const RefereeSetup& setup, const RefereeState& state,
                              DetectorMemory& memory);

/// The same with the areas counted by the caller (see reportAreas; hysteresis: `memory.areas`).
std::optional<Finding> detect(const DetectorInput& input, DetectorMemory& memory);

}  // namespace fulbito
