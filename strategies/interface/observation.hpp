#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/core/base/restart_kind.hpp"
#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"
#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/physics_profile.hpp"
#include "engine/core/models/robot_model.hpp"
#include "referee/rules/rules.hpp"
#include "strategies/interface/decision_time.hpp"

namespace fulbito {

/// What a team knows before the match. Plain values: what a team in another process would be sent.
struct MatchInfo {
  TeamId team = TeamId::kBlue;  ///< the colour that it plays in, and so its seat
  Side side = Side::kLeft;      ///< the goal that it defends when the match begins
  FieldGeometry field;
  RobotModel robot;  ///< of both teams
  BallModel ball;
  PhysicsProfile physics;
  Rules rules;                                ///< team size, length of the periods, and what is called
  double observation_age = 0.0;               ///< [s] nominal age of every observation
  double position_noise = 0.0;                ///< [m] standard deviation of observed positions
  double heading_noise = 0.0;                 ///< [rad] standard deviation of observed headings
  double dropout = 0.0;                       ///< chance that a body is not seen in a tick
  std::optional<DecisionTime> decision_time;  ///< how long it may think; empty: as long as it likes
  std::uint64_t seed = 0;                     ///< for the team's own random stream

  /// [s] Control period: one decision for each.
  double dt() const { return physics.controlPeriod(); }
};

/// A robot as the team sees it.
struct ObservedRobot {
  bool present = false;  ///< false: not on the field (sent off, or fewer robots play)
  RobotState state;      ///< team frame; an opponent's wheels are not observed and stay 0
};

/// All that a team may know at one control tick: a plain value in the team's frame (own goal at -x).
struct Observation {
  Tick tick = 0;           ///< of the picture; never reset during a match
  double dt = 1.0 / 60.0;  ///< [s] control period
  int team_size = 3;
  std::array<ObservedRobot, kMaxTeamSize> own;
  std::array<ObservedRobot, kMaxTeamSize> opponents;
  BallState ball;  ///< spin is not observed and stays 0
  /// What the own robots were told in the tick before, whatever the picture's age [rad/s]; 0 at a restart.
  std::array<WheelSpeeds, kMaxTeamSize> sent;
  bool playing = true;                          ///< false while a restart waits for its signal
  RestartKind restart = RestartKind::kKickOff;  ///< how the present play was begun
  bool restart_is_ours = false;                 ///< the team takes it (a free ball: it attacks that half)
  double since_restart = 0.0;                   ///< [s] of play; negative before the signal
  int period = 1;                               ///< 1, 2: halves; 3: overtime; 4: shoot-out
  double remaining = 0.0;                       ///< [s] of play left in the period
  int own_score = 0;
  int opponent_score = 0;
  bool wants_drawings = false;  ///< debug drawings of this tick will be kept
};

}  // namespace fulbito
