#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/core/base/restart_kind.hpp"
#include "engine/core/base/team.hpp"
#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/robot_model.hpp"
#include "referee/rules/rules.hpp"
#include "referee/state/placement.hpp"
#include "referee/state/scoreboard.hpp"

namespace fulbito {

/// A stoppage: what the referee called and how play goes on.
struct RestartCall {
  RestartKind kind = RestartKind::kKickOff;
  TeamId team = TeamId::kBlue;  ///< who takes it and places first; of a free ball: who attacks that half
  Vec2 ball;                    ///< [m] where the ball will lie
  Tick delay = 0;               ///< from the placement to the signal, in ticks
  bool defenders_back = false;  ///< law 9: the other team stands no farther than its own area's edge
  Placement defaults;           ///< the rules' own placement
  PerTeam<TeamPoses> stays;     ///< of a free ball where robots stay: where each would without taking a mark
  /// Of such a free ball: who stays exactly there, as it was not too near. Who takes the mark moves all the
  /// same.
  PerTeam<std::array<bool, kMaxTeamSize>> rests{};
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
  PerTeam<bool> present{true, true};  ///< false: the team did not come (law 7.3)
  Scoreboard scoreboard;              ///< how the match stands at its beginning
};

/// Number of a period in `RefereeState::period` and `GameEvent::period`.
inline constexpr int kOvertimePeriod = 3;
inline constexpr int kShootOutPeriod = 4;

/// How far a shoot-out has come.
struct ShootOutState {
  PerTeam<int> taken{};  ///< kicks
  PerTeam<int> goals{};  ///< not part of the match's score
  TeamId first = TeamId::kBlue;
  Tick still_ticks = 0;       ///< for how long the ball has been at rest
  Tick held_ticks = 0;        ///< for how long the keeper has held it
  bool entered_area = false;  ///< the ball has been in the keeper's area
};

/// A robot's record.
struct RobotRecord {
  int cards = 0;
  bool out = false;     ///< sent off; it comes back at the first restart when its time is over
  Tick back_after = 0;  ///< `RefereeState::match_ticks` from which it may come back
};

/// What the referee knows between ticks: a plain value.
struct RefereeState {
  Tick last_tick = 0;  ///< of the match, that the referee saw last
  int period = 1;      ///< 1, 2: halves; 3: overtime; 4: shoot-out
  int part = 1;        ///< of the overtime: 1, 2 ...
  /// Of play in this period: of overtime in its part, of the shoot-out in the kick.
  Tick play_ticks = 0;
  Tick period_ticks = 0;  ///< of play that the period lasts, counted as `play_ticks`
  Tick match_ticks = 0;   ///< of play in the match so far
  bool playing = false;   ///< false while a restart waits for its signal
  bool ended = false;
  PerTeam<int> score{};
  std::optional<TeamId> winner;           ///< once ended: empty after a draw
  Side blue_side = Side::kLeft;           ///< which goal blue defends now
  TeamId first_kick_off = TeamId::kBlue;  ///< who began period 1
  RestartCall last;                       ///< how play was last begun
  Placement placed;                       ///< where all stood then
  Tick play_began = 0;                    ///< tick of the match: of the signal
  bool announce = false;                  ///< the next tick of play tells of the kick-off
  PerTeam<int> false_starts{};            ///< at this restart and those that it led to
  Tick false_start_ticks = 0;             ///< for how long a robot has been off its place
  ShootOutState shoot_out;
  PerTeam<std::array<RobotRecord, kMaxTeamSize>> robots{};

  Side sideOf(TeamId team) const { return team == TeamId::kBlue ? blue_side : opposite(blue_side); }
};

}  // namespace fulbito
