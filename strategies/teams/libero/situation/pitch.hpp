#pragma once

#include "engine/core/models/drive_law.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito::libero {

/// The field and the bodies as the team's skills need them, in the team's frame: own goal at -x. All from the
/// models that the match is played with.
struct Pitch {
  Pitch() : Pitch(MatchInfo{}) {}
  explicit Pitch(const MatchInfo& info);

  Vec2 ownGoal() const { return {-half_length, 0.0}; }
  Vec2 theirGoal() const { return {half_length, 0.0}; }
  /// Five a side, where crowds push through what three cannot.
  bool isLarge() const { return team_size > 3; }

  FieldGeometry field;
  RobotPace pace;
  double half_length;   ///< [m]
  double half_width;    ///< [m]
  double goal_half;     ///< [m]
  double area_half;     ///< [m] half width of the goal area
  double ball_radius;   ///< [m]
  double robot_half;    ///< [m] half of the longer side
  double robot_corner;  ///< [m] centre to corner
  double speed;         ///< [m/s] of a robot at most
  double acceleration;  ///< [m/s^2] straight on
  double half_track;    ///< [m]
  double wheel_radius;  ///< [m]
  double tick;          ///< [s] control period
  DriveLaw motors;      ///< in a tick
  int team_size;
};

}  // namespace fulbito::libero
