#pragma once

#include "engine/core/models/drive_law.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito::libero {

/// Dimensions of field and bodies that the skills need, in the team's frame (own goal at -x), from the
/// match's models.
struct Pitch {
  Pitch() : Pitch(MatchInfo{}) {}
  explicit Pitch(const MatchInfo& info);

  Vec2 ownGoal() const { return {-half_length, 0.0}; }
  Vec2 theirGoal() const { return {half_length, 0.0}; }
  /// Whether the teams have more than three robots; crowds then push through where three cannot.
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
  double speed;         ///< [m/s] top speed of a robot
  double acceleration;  ///< [m/s^2] of a robot that drives straight
  double braking;       ///< [m/s^2] of a robot that drives straight
  double turning;       ///< [rad/s^2] of a robot's twists
  double sliding;       ///< [m/s^2] deceleration of a robot that is pushed sideways
  double half_track;    ///< [m]
  double wheel_radius;  ///< [m]
  double tick;          ///< [s] control period
  DriveLaw motors;      ///< effect of the motors in one tick
  int team_size;
};

}  // namespace fulbito::libero
