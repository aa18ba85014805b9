// Private header of strategies: not installed.
#pragma once

#include "engine/core/models/drive_law.hpp"
#include "strategies/interface/observation.hpp"

namespace fulbito::libero {

/// The field and the bodies as the team's skills need them, in the team's frame: own goal at -x.
struct Pitch {
  Pitch() = default;
  explicit Pitch(const MatchInfo& info);

  /// `p` moved onto the field so far that a body of half size `margin` [m] fits, corner cuts included.
  Vec2 inside(Vec2 p, double margin) const;
  Vec2 ownGoal() const { return {-half_length, 0.0}; }
  Vec2 theirGoal() const { return {half_length, 0.0}; }
  /// Five a side, where crowds push through what three cannot.
  bool isLarge() const { return team_size > 3; }

  double half_length = 0.75;                  ///< [m]
  double half_width = 0.65;                   ///< [m]
  double goal_half = 0.20;                    ///< [m]
  double corner = 0.07;                       ///< [m] legs of the corner cuts
  double area_half = 0.35;                    ///< [m] half width of the goal area
  double area_depth = 0.15;                   ///< [m]
  double arc_half = 0.10;                     ///< [m] half chord of the area's arc
  double arc_depth = 0.05;                    ///< [m]
  double big_area_depth = 0.0;                ///< [m] of the larger games' big area
  double circle = 0.20;                       ///< [m] radius of the centre circle
  double ball_radius = 0.0215;                ///< [m]
  double robot_half = 0.0375;                 ///< [m] half of the longer side
  double robot_corner = 0.053;                ///< [m] centre to corner
  double speed = 1.2;                         ///< [m/s] of a robot at most
  double acceleration = 7.0;                  ///< [m/s^2] straight on
  double turning = 289.0;                     ///< [rad/s^2] in place, at most
  double half_track = 0.03875;                ///< [m]
  double wheel_radius = 0.026;                ///< [m]
  DriveLaw motors{RobotModel{}, 1.0 / 60.0};  ///< in a tick
  int team_size = 3;
};

}  // namespace fulbito::libero
