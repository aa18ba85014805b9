#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"

namespace fulbito {

/// A place to drive to, in the team's frame. The navigation stage plans the way among the other robots.
struct GoTo {
  Vec2 position;
  std::optional<double> heading;  ///< [rad] wanted on arrival
  bool stop = false;              ///< come to rest there; otherwise pass at speed
  double speed_limit = std::numeric_limits<double>::infinity();  ///< [m/s]
  bool avoid_ball = false;                                       ///< the ball is an obstacle too
  bool avoid_mates = true;
  bool avoid_opponents = true;
  double tolerance = 0.03;  ///< [m]
  /// Either end of the robot may lead; `heading` is the direction of travel. False: the front leads.
  bool either_front = true;
  std::uint8_t navigator = 0;  ///< which of the strategy's navigators drives
};

/// What one robot shall do until the next decision.
struct RobotCommand {
  enum class Kind : std::uint8_t {
    kWheels,  ///< `wheels` as they are
    kTwist,   ///< `twist`, limited so that the robot can always steer
    kGoTo     ///< `go_to` by a navigator
  };
  Kind kind = Kind::kWheels;
  WheelSpeeds wheels;  ///< [rad/s]
  Twist twist;
  GoTo go_to;

  static RobotCommand byWheels(WheelSpeeds wheels) { return {Kind::kWheels, wheels, {}, {}}; }
  static RobotCommand byTwist(Twist twist) { return {Kind::kTwist, {}, twist, {}}; }
  static RobotCommand drivingTo(GoTo go_to) { return {Kind::kGoTo, {}, {}, go_to}; }
};

/// Something that a strategy wants to show a viewer, in the team's frame.
struct DebugDrawing {
  enum class Kind : std::uint8_t { kLine, kCircle, kText };
  Kind kind = Kind::kLine;
  Vec2 from;            ///< centre of a circle or a text
  Vec2 to;              ///< end of a line
  double radius = 0.0;  ///< [m] of a circle
  std::string text;
};

/// A team's decision for one tick: a plain value.
struct TeamCommand {
  std::array<RobotCommand, kMaxTeamSize> robots;
  /// Left empty unless `Observation::wants_drawings`; nothing in a match depends on it.
  std::vector<DebugDrawing> drawings;
  /// What each robot plays, as the team numbers its roles from 1; 0: not told. Nothing in a match depends on
  /// it: drills count how often roles change hands.
  std::array<std::uint8_t, kMaxTeamSize> roles{};
};

}  // namespace fulbito
