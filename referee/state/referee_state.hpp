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

/// A restart: how play continues after a stoppage.
struct RestartCall {
  RestartKind kind = RestartKind::kKickOff;
  TeamId team = TeamId::kBlue;  ///< takes it and places first; for a free ball, attacks that half
  Vec2 ball;                    ///< [m] ball position
  Tick delay = 0;               ///< from the placement to the signal, in ticks
  bool defenders_back = false;  ///< law 9: the other team must stay behind the edge of its own area
  Placement defaults;           ///< placement by the rules
  PerTeam<TeamPoses> stays;     ///< for a free ball at which robots stay: each one's pose if it takes no mark
  /// For such a free ball: robots that stay exactly there, since they are far enough from the ball. The robot
  /// that takes the mark moves anyway.
  PerTeam<std::array<bool, kMaxTeamSize>> rests{};
};

/// The referee's constants during a match.
struct RefereeSetup {
  Rules rules;
  FieldGeometry field;
  RobotModel robot;
  BallModel ball;
  double dt = 1.0 / 60.0;  ///< [s] control period
  std::uint64_t seed = 0;  ///< of the match: coin tosses
  Side blue_side = Side::kLeft;
  PerTeam<bool> present{true, true};  ///< false: the team is absent (law 7.3)
  Scoreboard scoreboard;              ///< score and time at the start
};

/// Number of a period in `RefereeState::period` and `GameEvent::period`.
inline constexpr int kOvertimePeriod = 3;
inline constexpr int kShootOutPeriod = 4;

/// The state of a shoot-out.
struct ShootOutState {
  PerTeam<int> taken{};  ///< kicks
  PerTeam<int> goals{};  ///< not part of the match's score
  TeamId first = TeamId::kBlue;
  Tick still_ticks = 0;       ///< time for which the ball has been at rest
  Tick held_ticks = 0;        ///< time for which the keeper has held it
  bool entered_area = false;  ///< the ball has been in the keeper's area
};

/// A robot's record.
struct RobotRecord {
  int cards = 0;
  bool out = false;     ///< sent off; it returns at the first restart after its time
  Tick back_after = 0;  ///< `RefereeState::match_ticks` from which it may return
};

/// The referee's state between ticks: a plain value.
struct RefereeState {
  Tick last_tick = 0;  ///< the match's last tick that the referee saw
  int period = 1;      ///< 1, 2: halves; 3: overtime; 4: shoot-out
  int part = 1;        ///< period of overtime: 1, 2 ...
  /// Play time in this period (overtime: in its part; shoot-out: in the kick).
  Tick play_ticks = 0;
  Tick period_ticks = 0;  ///< length of the period, counted as `play_ticks`
  Tick match_ticks = 0;   ///< play time in the match
  bool playing = false;   ///< false while a restart waits for its signal
  bool ended = false;
  PerTeam<int> score{};
  std::optional<TeamId> winner;           ///< after the end; empty for a draw
  Side blue_side = Side::kLeft;           ///< goal that blue defends now
  TeamId first_kick_off = TeamId::kBlue;  ///< team that began period 1
  RestartCall last;                       ///< the last restart
  Placement placed;                       ///< the placement at that restart
  Tick play_began = 0;                    ///< match tick of the signal
  bool announce = false;                  ///< the next tick of play reports the kick-off
  PerTeam<int> false_starts{};            ///< at this restart and its repeats
  Tick false_start_ticks = 0;             ///< time for which a robot has been off its place
  ShootOutState shoot_out;
  PerTeam<std::array<RobotRecord, kMaxTeamSize>> robots{};

  Side sideOf(TeamId team) const { return team == TeamId::kBlue ? blue_side : opposite(blue_side); }
};

}  // namespace fulbito
