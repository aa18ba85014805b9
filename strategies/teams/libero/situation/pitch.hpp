#pragma once

#include "engine/core/models/drive_law.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/situation/tuning.hpp"

namespace fulbito::libero {

/// Dimensions of field and bodies that the skills need, in the team's frame (own goal at -x), from the
/// match's models and rules, and what follows from them. Skills measure by these scales and by the tuned
/// numbers, and have no lengths, times and gains of their own.
struct Pitch {
  Pitch() : Pitch(MatchInfo{}) {}
  explicit Pitch(const MatchInfo& info, const Tuning& tuned = {});

  Vec2 ownGoal() const { return {-half_length, 0.0}; }
  Vec2 theirGoal() const { return {half_length, 0.0}; }
  /// Whether the teams have more than three robots; crowds then push through where three cannot.
  bool isLarge() const { return team_size > 3; }

  /// Deceleration [m/s^2] that a robot plans with when it drives straight.
  double plannedBraking() const { return tuning.braking_share * braking; }
  /// [m/s^2] the same for its acceleration.
  double plannedSpeedingUp() const { return tuning.braking_share * acceleration; }
  /// [rad/s^2] the same for its turns.
  double plannedTurning() const { return tuning.braking_share * turning; }

  Tuning tuning;
  FieldGeometry field;
  RobotPace pace;
  double half_length;   ///< [m]
  double half_width;    ///< [m]
  double goal_half;     ///< [m]
  double area_half;     ///< [m] half width of the goal area
  double area_front;    ///< [m] depth of the goal area with its arc
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
  /// @{ Distances [m] between centres.
  double front;   ///< robot and ball that touches the middle of a side
  double touch;   ///< robot and ball that touch, at any heading of the robot
  double bodies;  ///< two robots that touch corner to corner: farther apart, no heading lets them touch
  double around;  ///< two robots with the ball between their sides
  /// @}
  int ticks_to_rest;   ///< until a robot that brakes from its top speed rests, after one tick of any command
  int ticks_to_start;  ///< in which a robot that stands has moved noticeably
  double stop_time;    ///< [s] to stop from top speed
  double turn_time;    ///< [s] of a quarter turn in place, from rest to rest
  double turn_rate;    ///< [rad/s] greatest yaw rate of such a turn
  double creep;        ///< [m/s] speed of a ball that rolls less than its radius before it rests
  /// @{ A robot's hit on the ball: what it adds to the ball's velocity.
  double bounce;              ///< share of the face's speed relative to the ball, along the face's normal
  double rub;                 ///< most change along the face, as a share of that
  double roll_keep;           ///< share of both that is left once the ball rolls
  double slide_deceleration;  ///< [m/s^2] of the ball until it rolls
  /// @}
  double stuck_radius;  ///< [m] of the circle in which referees count a ball as stuck
  double stuck_time;    ///< [s] after which they give a free ball for it
  double charge_time;   ///< [s] after which they punish a robot that presses on the keeper without the ball
  /// Whether two robots that push can move one that resists. Where they cannot, duels stand still, robots
  /// speed up slowly, and spins are what moves a ball.
  bool shoves;
  DriveLaw motors;  ///< effect of the motors in one tick
  int team_size;
};

}  // namespace fulbito::libero
