// Values that all components share: vectors, poses, states, teams, contacts, errors. Units are SI. The world
// frame has its origin at the field's centre, x toward the right goal, y up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// The category of an error in external input (file, flag, packet). Each has its own exit code of the
/// program.
enum class ErrorCode {
  kUsage,     ///< the caller gave an invalid name or value (exit 2)
  kBadInput,  ///< a file is readable but its content is wrong (exit 3)
  kIo,        ///< a file or folder cannot be read or written (exit 5)
  /// the machine lacks memory, processes, descriptors or room; a later attempt may succeed (exit 6)
  kMachine,
  kInterrupted,  ///< stopped by a signal before the end (exit 130)
};

/// An error with a message that names the file, line, key or flag, and the allowed range.
struct Error {
  ErrorCode code = ErrorCode::kUsage;  ///< for programs
  std::string message;                 ///< for people, without a line end
};

/// A value or an error: `if (!result)` use `result.error()`, otherwise `*result`.
template <typename T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function that returns a Result.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message)});
}

/// Control ticks since the world's creation. Seconds are `tick * dt`, never a running sum.
using Tick = std::int64_t;

/// World frame: field centre, x toward the right goal, y up.
struct Pose2 {
  Vec2 position;         ///< [m]
  double heading = 0.0;  ///< [rad] in [-pi, pi), counter-clockwise, 0 along +x
};

/// Body-frame motion of a differential-drive robot (x forward).
struct Twist {
  double linear = 0.0;   ///< [m/s] forward
  double angular = 0.0;  ///< [rad/s] counter-clockwise
};

/// Wheel rotation; positive drives forward.
struct WheelSpeeds {
  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]
};

/// The motion of a robot at one tick; in the world frame unless stated otherwise.
struct RobotState {
  Pose2 pose;                     ///< pose of its centre
  Vec2 velocity;                  ///< [m/s] world frame
  double angular_velocity = 0.0;  ///< [rad/s]
  WheelSpeeds wheels;             ///< [rad/s] encoder readings: they differ from the ground speed during slip
};

/// The motion of a ball at one tick; in the world frame unless stated otherwise.
struct BallState {
  Vec2 position;  ///< [m] its centre
  Vec2 velocity;  ///< [m/s]
  Vec2 spin;      ///< [m/s] spin times radius: the velocity at which the ball would roll without sliding
};

/// The motion of an obstacle at one tick, in the world frame.
struct ObstacleState {
  Pose2 pose;     ///< pose of its centre
  Vec2 velocity;  ///< [m/s]
};

/// The motion of a rod that two robots carry, at one tick, in the world frame.
struct RodState {
  Pose2 pose;     ///< pose of its centre; its heading leads from the first robot to the second
  Vec2 velocity;  ///< [m/s]
  double angular_velocity = 0.0;  ///< [rad/s]
  /// [N] by the first and the second robot on the rod: means over the tick.
  std::array<Vec2, 2> forces{};
};

/// The state of all moving bodies of a world, as a plain value.
struct WorldState {
  Tick tick = 0;                         ///< ticks since the world's creation
  std::vector<RobotState> robots;        ///< in the order of `WorldConfig::robots`
  std::vector<BallState> balls;          ///< in the order of `WorldConfig::balls`
  std::vector<ObstacleState> obstacles;  ///< in the order of `WorldConfig::obstacles`
  std::vector<RodState> rods = {};       ///< in the order of `WorldConfig::rods`
};

/// The kinds of bodies that can touch.
enum class BodyKind : std::uint8_t { kWall, kRobot, kBall, kObstacle };

/// One body of a world: its kind and its index in the world's list of that kind (0 for the walls).
struct BodyId {
  BodyKind kind = BodyKind::kWall;  ///< selects one of the world's lists
  std::uint16_t index = 0;          ///< index in that list, from 0
  friend bool operator==(BodyId, BodyId) = default;
};

/// A contact: two bodies that press on each other during a control tick. Bodies close to each other without
/// force make no contact. There is one event per pair and tick, sorted by (a, b), independent of the physics
/// engine's order.
struct ContactEvent {
  BodyId a;              ///< the body that comes first in the order walls, robots, balls, obstacles
  BodyId b;              ///< the other body
  Vec2 point;            ///< [m] world frame, at the first impulse of the tick
  Vec2 normal;           ///< unit, from a to b
  double impulse = 0.0;  ///< [kg m/s] along the normal, summed over the tick
  bool began = false;    ///< the two did not touch in the previous tick, with or without force
};

/// Largest number of robots per team.
inline constexpr int kMaxTeamSize = 11;

/// The two teams of a match.
enum class TeamId : std::uint8_t { kBlue, kYellow };
/// The goal that a team defends: kLeft is the one at -x of the world frame.
enum class Side : std::uint8_t { kLeft, kRight };

/// The opponents.
constexpr TeamId other(TeamId team) { return team == TeamId::kBlue ? TeamId::kYellow : TeamId::kBlue; }
/// The goal at the other end.
constexpr Side opposite(Side side) { return side == Side::kLeft ? Side::kRight : Side::kLeft; }
/// Index of a team in lists of two: blue 0, yellow 1.
constexpr std::size_t indexOf(TeamId team) { return static_cast<std::size_t>(team); }
inline constexpr std::array<TeamId, 2> kTeams{TeamId::kBlue, TeamId::kYellow};  ///< both teams, to loop over
/// "blue" or "yellow", as in files and tables.
constexpr const char* nameOf(TeamId team) { return team == TeamId::kBlue ? "blue" : "yellow"; }

/// One robot of a match: its team and its number in the team, from 0.
struct RobotId {
  TeamId team = TeamId::kBlue;  ///< the robot's team
  std::uint8_t number = 0;      ///< 0 ... `kMaxTeamSize` - 1
  friend bool operator==(RobotId, RobotId) = default;
};

/// One value per team, indexed by `indexOf(team)`.
template <typename T>
using PerTeam = std::array<T, 2>;

/// The kinds of restarts. The numbers are part of the recording format: append, never renumber.
enum class RestartKind : std::uint8_t {
  kKickOff,   ///< from the centre: at the start of a half and after a goal
  kFreeBall,  ///< from one of four marks, with a robot of each team next to it: after a stuck ball
  kFreeKick,  ///< by one team from its mark, after a foul
  kPenalty,   ///< by one team from its mark, against the keeper alone
  kGoalKick,  ///< by one team from its own goal area
  kGiven      ///< from a placement by the user or a drill
};

/// Name of a kind of restart as in files and tables, e.g. "kick-off".
constexpr const char* nameOf(RestartKind kind) {
  constexpr const char* names[] = {"kick-off", "free-ball", "free-kick", "penalty", "goal-kick", "given"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace fulbito
