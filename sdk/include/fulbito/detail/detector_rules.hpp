#pragma once

namespace fulbito {

/// The part of a body that must be inside a marking to count as inside.
enum class BodyPart { kAnyPart, kHalf, kCentre };

/// The part of the ball that must be past the goal line.
enum class BallPart { kWhole, kCentre };

/// [goal] Law 7.1.
struct GoalRules {
  BallPart ball = BallPart::kWhole;  ///< part of the ball past the line
  double scorer_seconds = 5.0;       ///< [s] a robot is the scorer only if it touched the ball this recently
  bool attack_foul_voids = true;     ///< a goal after a foul of the attackers (8.2) is a goal kick
};

/// The criterion for a stuck ball.
enum class StuckMeasure {
  kRadius,  ///< it stays within a circle around its position at the start of the count
  kSpeed    ///< it is slow
};

/// The call for a ball that is stuck in a goal area without robots of both teams near it. Law 13 gives a goal
/// kick after ten seconds of stalemate between keeper and attacker. Law 14 gives a free ball only outside the
/// areas. Law 8.1 gives a penalty if the keeper holds the ball. No law gives a penalty for an undisputed
/// ball: the default is a goal kick, the only restart for a stalemate in the area.
enum class UndisputedCall { kPenalty, kGoalKick };

/// The place that counts for a stuck ball both inside and outside a goal area during the count.
enum class StuckPlace {
  kMost,  ///< its place for most of the count; in the area if the times are equal
  kNow    ///< its place at the end of the count
};

/// The foul that counts if both attackers (8.2) and defenders (8.3) commit one at the same goal.
enum class BothFouls {
  kAttackers,  ///< the attackers'
  kLonger      ///< the longer one; the attackers' if the times are equal
};

/// [stuck] Laws 13 and 14. While a keeper has undisputed control (`KeeperRules`), the count pauses: those
/// seconds count for law 8.1.
struct StuckRules {
  StuckMeasure measure = StuckMeasure::kRadius;  ///< which motion of the ball counts
  double seconds = 10.0;                         ///< [s] outside the goal areas
  double area_seconds = 10.0;                    ///< [s] in a goal area
  double radius = 0.10;                          ///< [m] leaving this circle restarts the count
  double speed = 0.1;            ///< [m/s] for kSpeed: a ball at most this fast starts a count
  double release_speed = 0.15;   ///< [m/s] faster balls end the count: hysteresis
  double release_seconds = 0.1;  ///< [s] uninterrupted time above `release_speed` that ends the count
  double dispute_lengths =
      1.5;  ///< [robot lengths] a robot with its centre this close to the ball disputes it
  UndisputedCall undisputed = UndisputedCall::kGoalKick;  ///< the call in a goal area without a dispute
  StuckPlace place = StuckPlace::kMost;  ///< the place that counts if the ball entered or left an area
};

/// [areas] Laws 8.2 and 8.3.
struct AreaRules {
  bool arc = true;            ///< the goal area includes its arc
  double hysteresis = 0.002;  ///< [m] a robot counts as inside until it is this far outside
  double part_seconds = 0.5;  ///< [s] a robot with contact this recently takes part
  bool attackers = true;      ///< enables law 8.2
  int attackers_max = 1;      ///< robots allowed in the opponents' goal area
  BodyPart attackers_part = BodyPart::kAnyPart;  ///< part that must be inside
  bool attackers_need_ball = false;              ///< the ball must be in the area too
  bool attackers_take_part = true;               ///< a robot beyond the first must take part
  double attackers_wait = 0.0;                   ///< [s] wait for a goal, or for the ball to leave the area
  int big_attackers_max = 3;                     ///< robots allowed in the opponents' big area
  bool defenders = true;                         ///< enables law 8.3
  int defenders_max = 1;                         ///< robots allowed in the own goal area with the ball
  BodyPart defenders_part = BodyPart::kHalf;     ///< part that must be inside
  bool defenders_take_part = true;               ///< a robot beyond the first must take part
  double defenders_wait = 1.0;                   ///< [s] wait for a goal, or for the ball to leave the area
  int big_defenders_max = 3;                     ///< robots allowed in the own big area with the ball
  bool pushed_excused = true;                    ///< a robot pushed in while disputing does not count
  double pushed_seconds = 0.5;                   ///< [s] longest break in a push, and between push and entry
  double pushed_impulse = 0.01;                  ///< [kg m/s] least impulse of the push toward the goal
  double excuse_seconds = 3.0;                   ///< [s] time for a pushed robot to leave
  double cool_down = 0.5;                        ///< [s] no such call within this time of the start of play
  BothFouls both = BothFouls::kAttackers;        ///< the foul that counts if both teams commit one
};

/// [keeper] Laws 2.2.3, 8.1 and 13.
struct KeeperRules {
  bool holding = true;           ///< enables the call for holding the ball too long
  double hold_seconds = 10.0;    ///< [s] longest undisputed control
  double control_gap = 0.01;     ///< [m] largest gap between body and ball for control
  double release_seconds = 0.5;  ///< [s] time without control that ends the count
  double dispute_lengths = 1.5;  ///< [robot lengths] an opponent this close to the ball restarts the count
  bool charged = true;           ///< enables the calls for charging and blocking
  double charge_seconds = 0.2;   ///< [s] least duration of the contact
  double charge_impulse = 0.02;  ///< [kg m/s] least total impulse of the contact
  double charge_release = 0.05;  ///< [s] time without contact that ends it
  double part_seconds = 0.5;     ///< [s] a robot that touched the ball this recently disputes it
  double cool_down = 0.5;        ///< [s] no such call within this time of the start of play
};

/// [fouls] Law 8.1.
struct FoulRules {
  bool push = false;             ///< enables the call for pushing away from the ball
  double push_seconds = 0.5;     ///< [s] least duration of the contact
  double push_impulse = 0.04;    ///< [kg m/s] least total impulse of the contact
  double push_speed = 0.10;      ///< [m/s] least speed of the pushed robot
  double push_distance = 0.15;   ///< [m] least distance of both centres from the ball
  double push_release = 0.05;    ///< [s] time without contact that ends it
  double part_seconds = 0.5;     ///< [s] a robot that touched the ball this recently disputes it
  bool holding = false;          ///< enables the call for pinning the ball to a wall; not for the keeper
  double pinned_seconds = 3.0;   ///< [s] longest time for pinning an undisputed ball to a wall
  double pinned_speed = 0.1;     ///< [m/s] largest speed of ball and robot for pinning
  double holding_release = 0.2;  ///< [s] time without pinning that ends it
  double dispute_lengths = 1.5;  ///< [robot lengths] an opponent this close to the ball disputes it
  double cool_down = 0.5;        ///< [s] no such call within this time of the start of play
};

}  // namespace fulbito
