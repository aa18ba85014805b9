#pragma once

#include <optional>
#include <vector>

#include "engine/core/ball_model.hpp"
#include "engine/core/field_geometry.hpp"
#include "engine/core/restart_kind.hpp"
#include "engine/core/robot_model.hpp"
#include "referee/game_event.hpp"
#include "referee/match_view.hpp"
#include "referee/placement.hpp"
#include "referee/rules.hpp"
#include "referee/scoreboard.hpp"

namespace fulbito {

/// A stoppage: what the referee called and how play goes on.
struct RestartCall {
  RestartKind kind = RestartKind::kKickOff;
  TeamId team = TeamId::kBlue;  ///< who takes it; of a free ball: who attacks that half
  Vec2 ball;                    ///< [m] where the ball will lie
  Placement defaults;           ///< the rules' own placement
};

/// What the referee works with during the whole match.
struct RefereeSetup {
  Rules rules;
  FieldGeometry field;
  RobotModel robot;
  BallModel ball;
  double dt = 1.0 / 60.0;  ///< [s] control period
  std::uint64_t seed = 0;  ///< of the match: coin tosses
  Side blue_side = Side::kLeft;
  Scoreboard scoreboard;  ///< how the match stands at its beginning
};

/// What the referee knows between ticks: a plain value.
struct RefereeState {
  int period = 1;        ///< 1, 2: halves; 3: overtime; 4: shoot-out
  Tick play_ticks = 0;   ///< of play in this period
  bool playing = false;  ///< false while a restart waits for its signal
  bool ended = false;
  PerTeam<int> score{};
  Side blue_side = Side::kLeft;  ///< which goal blue defends now
  RestartCall last;              ///< how play was last begun
  Tick play_began = 0;           ///< tick of the match
};

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
