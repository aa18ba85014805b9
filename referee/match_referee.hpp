#pragma once

#include <optional>
#include <vector>

#include "referee/game_event.hpp"
#include "referee/match_view.hpp"
#include "referee/referee_state.hpp"

namespace fulbito {

/// Referee of a whole match. Pure: the same setup and the same views give the same calls.
class MatchReferee {
 public:
  explicit MatchReferee(const RefereeSetup& setup);
  /// The match's first restart.
  RestartCall open();
  /// Takes in one tick of play; events of the tick are appended. A value: play is stopped and goes on from
  /// there, until when the referee must be told with `restarted`.
  std::optional<RestartCall> observe(const MatchView& view, std::vector<GameEvent>& events);
  /// Play begins from this placement.
  void restarted(const RestartCall& call, const Placement& placement, Tick tick);
  const RefereeState& state() const { return state_; }
  const RefereeSetup& setup() const { return setup_; }

 private:
  RestartCall kickOff(TeamId team) const;
  RefereeSetup setup_;
  RefereeState state_;
};

}  // namespace fulbito
