// Rules of a match as numbers, and the referee's state, calls and restarts. Component `referee`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/decision_time.hpp"
#include "fulbito/detail/detector_rules.hpp"
#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/period_rules.hpp"
#include "fulbito/detail/restart_rules.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Poses of one team's robots by number. A robot without a pose is not on the field.
using TeamPoses = std::array<std::optional<Pose2>, kMaxTeamSize>;

/// Positions of ball and robots in the world frame. A robot without a pose is not on the field.
struct Placement {
  Vec2 ball;                  ///< [m] its centre
  Vec2 ball_velocity;         ///< [m/s] 0 at every restart of the rules
  PerTeam<TeamPoses> robots;  ///< by team and number
};

/// Score and time at the start of a match.
struct Scoreboard {
  PerTeam<int> score{};       ///< goals of blue and yellow
  int period = 1;             ///< 1, 2: halves; 3: overtime
  double play_seconds = 0.0;  ///< [s] elapsed play time in that period
};

/// Play time [s] after a foul within which a goal of the same team counts as a gain from the foul.
inline constexpr double kFoulPaysWithin = 5.0;

/// One call of the referee, with its measured value.
struct GameEvent {
  Tick tick = 0;                      ///< tick of the match
  double play_time = 0.0;             ///< [s] play time in the period
  std::uint8_t period = 1;            ///< 1, 2: halves; 3: overtime; 4: shoot-out
  std::string_view clause;            ///< name of the rule, e.g. "goal-kick.attackers"; static lifetime
  std::string_view law;               ///< section of the rule book, e.g. "8.2"; static lifetime
  std::optional<TeamId> team;         ///< team that the call is against; for a goal, the scoring team
  std::optional<std::uint8_t> robot;  ///< the robot at fault or the scorer, if known
  Vec2 place;                         ///< [m] the ball's position, world frame
  double value = 0.0;                 ///< measured value, in the unit of the threshold
  double threshold = 0.0;             ///< limit of the rule
  double margin = 0.0;                ///< distance of the value from the limit; positive
};

/// The rules of a match. Defaults: the rule book's 3v3 game (IEEE VSSS rules).
struct Rules {
  std::string name = "vsss-3v3";   ///< name of the preset
  std::string field = "vsss-3v3";  ///< field preset or file
  int team_size = 3;               ///< robots per team
  double half_seconds = 300.0;     ///< [s] play time of a half; a key of [periods]
  PeriodRules periods;             ///< halves, overtime, first kick-off
  ShootOutRules shoot_out;         ///< the kicks that decide a tie
  WalkOverRules walk_over;         ///< an absent team
  DecisionTime decision_time;      ///< limits of teams that run outside the program
  RestartRules restart;            ///< rules of all restarts
  KickOffRules kick_off;           ///< places and distances
  FreeBallRules free_ball;         ///< places and distances
  FreeKickRules free_kick;         ///< places and distances
  PenaltyRules penalty;            ///< places and distances
  GoalKickRules goal_kick;         ///< places and distances
  GoalRules goal;                  ///< when a goal counts
  StuckRules stuck;                ///< when a ball is stuck, and the call
  AreaRules areas;                 ///< number of robots in the goal areas
  KeeperRules keeper;              ///< holding the ball, and charging the keeper
  FoulRules fouls;                 ///< pushing and holding
};

/// Reads a profile: a preset's name or the path of a TOML file. Missing keys keep the defaults of `Rules`; a
/// missing name becomes the file's. A relative path of a field starts at the profile's folder; the field must
/// load. Errors: kUsage for an unknown name (with a suggestion), kIo for an unreadable file, kBadInput as
/// `file:line: table.key ...` with the range.
Result<Rules> loadRules(const std::string& name_or_file);
/// Parses a profile from text; `origin` stands for the file name in errors. Opens no field.
Result<Rules> parseRules(std::string_view text, const std::string& origin);
/// Checks ranges and consistency; the error names the key.
Result<void> validate(const Rules& rules);
/// All keys with units, meanings and sources, as the text of a TOML file that `parseRules` reads back to the
/// same bits.
std::string toToml(const Rules& rules);
/// Names of the embedded profiles.
std::vector<std::string> rulesPresetNames();
/// The text of an embedded profile with all keys, defaults included. Errors: kUsage, with a suggestion.
Result<std::string> rulesPresetText(const std::string& name);

/// A restart: how play continues after a stoppage.
struct RestartCall {
  RestartKind kind = RestartKind::kKickOff;  ///< the kind of restart
  TeamId team =
      TeamId::kBlue;  ///< the team that takes it and places first; at a free ball it attacks that half
  Vec2 ball;          ///< [m] ball position
  Tick delay = 0;     ///< from the placement to the signal, in ticks
  bool defenders_back = false;  ///< law 9: the other team must stay behind the edge of its own area
  Placement defaults;           ///< placement by the rules
  PerTeam<TeamPoses> stays;     ///< for a free ball at which robots stay: pose of each robot without a mark
  /// For such a free ball: robots far enough from the ball to stay exactly there. The robot that takes the
  /// mark moves anyway.
  PerTeam<std::array<bool, kMaxTeamSize>> rests{};
};

/// The referee's constants during a match.
struct RefereeSetup {
  Rules rules;                        ///< rules of the match
  FieldGeometry field;                ///< field of the match
  RobotModel robot;                   ///< robots of both teams
  BallModel ball;                     ///< its radius decides on goals
  double dt = 1.0 / 60.0;             ///< [s] control period
  std::uint64_t seed = 0;             ///< seed of the match, for coin tosses
  Side blue_side = Side::kLeft;       ///< the goal that blue defends at first
  PerTeam<bool> present{true, true};  ///< false: the team is absent (law 7.3)
  Scoreboard scoreboard;              ///< score and time at the start
};

/// Number of a period in `RefereeState::period` and `GameEvent::period`.
inline constexpr int kOvertimePeriod = 3;
inline constexpr int kShootOutPeriod = 4;  ///< decides a tied match
/// [s] Play time of a period by the rules: of a half, of a part of overtime, or of a kick of the shoot-out.
double periodSeconds(const Rules& rules, int period);

/// The state of a shoot-out.
struct ShootOutState {
  PerTeam<int> taken{};          ///< kicks of blue and yellow so far
  PerTeam<int> goals{};          ///< goals in the shoot-out, not part of the match's score
  TeamId first = TeamId::kBlue;  ///< the team with the first kick of each pair
  Tick still_ticks = 0;          ///< ticks for which the ball has been at rest
  Tick held_ticks = 0;           ///< ticks for which the keeper has held the ball
  bool entered_area = false;     ///< the ball has been in the keeper's area
};

/// A robot's record.
struct RobotRecord {
  int cards = 0;        ///< yellow cards so far
  bool out = false;     ///< sent off; it returns at the first restart after its time
  Tick back_after = 0;  ///< `RefereeState::match_ticks` from which it may return
};

/// The referee's state between ticks: a plain value.
struct RefereeState {
  Tick last_tick = 0;  ///< the last tick that the referee saw
  int period = 1;      ///< 1, 2: halves; 3: overtime; 4: shoot-out
  int part = 1;        ///< period of overtime: 1, 2 ...
  /// Play time in this period (overtime: in its part; shoot-out: in the kick).
  Tick play_ticks = 0;
  Tick period_ticks = 0;                  ///< length of the period, counted as `play_ticks`
  Tick match_ticks = 0;                   ///< play time in the match
  bool playing = false;                   ///< false while a restart waits for its signal
  bool ended = false;                     ///< the match is over
  PerTeam<int> score{};                   ///< goals of blue and yellow
  std::optional<TeamId> winner;           ///< after the end; empty for a draw
  Side blue_side = Side::kLeft;           ///< goal that blue defends now
  TeamId first_kick_off = TeamId::kBlue;  ///< team that began period 1
  RestartCall last;                       ///< the last restart
  Placement placed;                       ///< the placement at that restart
  Tick play_began = 0;                    ///< match tick of the signal
  bool announce = false;                  ///< the next tick of play reports the kick-off
  PerTeam<int> false_starts{};            ///< at this restart and its repeats
  Tick false_start_ticks = 0;             ///< ticks for which a robot has been off its place
  ShootOutState shoot_out;                ///< state of the shoot-out
  PerTeam<std::array<RobotRecord, kMaxTeamSize>> robots{};  ///< by team and number

  /// The goal that a team defends now.
  Side sideOf(TeamId team) const { return team == TeamId::kBlue ? blue_side : opposite(blue_side); }
};

}  // namespace fulbito
