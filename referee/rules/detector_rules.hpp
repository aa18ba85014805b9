#pragma once

namespace fulbito {

/// How much of a body must be inside a marking to count as inside.
enum class BodyPart { kAnyPart, kHalf, kCentre };

/// How much of the ball must be past the goal line.
enum class BallPart { kWhole, kCentre };

/// [goal] Law 7.1.
struct GoalRules {
  BallPart ball = BallPart::kWhole;  ///< what must be past the line
  double scorer_seconds = 5.0;  ///< [s] the scorer's last touch is at most this long ago; else none is named
  bool attack_foul_voids = true;  ///< a goal after a foul of the attackers (8.2) is a goal kick
};

/// What tells that the ball is stuck.
enum class StuckMeasure {
  kRadius,  ///< it stays within a circle about where the count began
  kSpeed    ///< it is slow
};

/// What is called where the ball is stuck in a goal area and no robot disputes it with one of the other team.
/// Law 13 gives a goal kick after ten seconds between keeper and attacker, law 14 a free ball outside the
/// areas, law 8.1 a penalty for what the keeper holds. No law gives a penalty for a ball that nobody or only
/// attackers have, so the default is the one restart of the area's stalemate.
enum class UndisputedCall { kPenalty, kGoalKick };

/// Where a ball counts as stuck that lay partly in a goal area, partly outside.
enum class StuckPlace {
  kMost,  ///< where it lay for most of the count; after equal times in the area
  kNow    ///< where it lies when the count is over
};

/// Which of two fouls counts, of the attackers (8.2) and the defenders (8.3) at the same goal.
enum class BothFouls {
  kAttackers,  ///< the attackers'
  kLonger      ///< the one that lasted longer, after equal times the attackers'
};

/// [stuck] Laws 13 and 14. While a keeper has undisputed control (`KeeperRules`), the count stands: law 8.1
/// counts those seconds.
struct StuckRules {
  StuckMeasure measure = StuckMeasure::kRadius;
  double seconds = 10.0;         ///< [s] outside the goal areas
  double area_seconds = 10.0;    ///< [s] in a goal area
  double radius = 0.10;          ///< [m] a ball that leaves this circle begins a new count
  double speed = 0.1;            ///< [m/s] of measure kSpeed: at most this begins a count
  double release_speed = 0.15;   ///< [m/s] above this a count may end: hysteresis
  double release_seconds = 0.1;  ///< [s] that it must be above, without a break, to end the count
  double dispute_lengths =
      1.5;  ///< [robot lengths] a robot whose centre is within this of the ball disputes it
  UndisputedCall undisputed = UndisputedCall::kGoalKick;
  StuckPlace place = StuckPlace::kMost;
};

/// [areas] Laws 8.2 and 8.3.
struct AreaRules {
  bool arc = true;                               ///< the goal area includes its arc
  double hysteresis = 0.002;                     ///< [m] a robot inside counts until the grown area is left
  double part_seconds = 0.5;                     ///< [s] contact this recent is taking part
  bool attackers = true;                         ///< whether 8.2 is called at all
  int attackers_max = 1;                         ///< robots allowed in the opponents' goal area
  BodyPart attackers_part = BodyPart::kAnyPart;  ///< what counts as inside
  bool attackers_need_ball = false;              ///< the ball must be in the area too
  bool attackers_take_part = true;               ///< a robot beyond the first must take part
  double attackers_wait = 0.0;                ///< [s] for a goal, or for the ball to leave, before the call
  int big_attackers_max = 3;                  ///< robots allowed in the opponents' big area
  bool defenders = true;                      ///< whether 8.3 is called at all
  int defenders_max = 1;                      ///< robots allowed in the own goal area with the ball
  BodyPart defenders_part = BodyPart::kHalf;  ///< what counts as inside
  bool defenders_take_part = true;            ///< a robot beyond the first must take part
  double defenders_wait = 1.0;                ///< [s] for a goal, or for the ball to leave, before the call
  int big_defenders_max = 3;                  ///< robots allowed in the own big area with the ball
  bool pushed_excused = true;                 ///< a robot pushed in while disputing does not count
  double pushed_seconds = 0.5;                ///< [s] before it came in
  double pushed_impulse = 0.01;               ///< [kg m/s] toward the goal, in that time
  double excuse_seconds = 3.0;                ///< [s] that it has for leaving
  double cool_down = 0.5;                     ///< [s] after play began without a call of these laws
  BothFouls both = BothFouls::kAttackers;     ///< which one counts where both teams commit one
};

/// [keeper] Laws 2.2.3, 8.1 and 13.
struct KeeperRules {
  bool holding = true;           ///< whether holding the ball too long is called
  double hold_seconds = 10.0;    ///< [s] of undisputed control
  double control_gap = 0.01;     ///< [m] between body and ball, up to which the keeper controls it
  double release_seconds = 0.5;  ///< [s] without control that end the count
  double dispute_lengths = 1.5;  ///< [robot lengths] an opponent this near to the ball challenges
  bool charged = true;           ///< whether charging and blocking are called
  double charge_seconds = 0.2;   ///< [s] that the contact must last
  double charge_impulse = 0.02;  ///< [kg m/s] that it must give in all
  double charge_release = 0.05;  ///< [s] without contact that end it
  double part_seconds = 0.5;     ///< [s] a robot that touched the ball this recently disputes it
  double cool_down = 0.5;        ///< [s] after play began without a call of these laws
};

/// [fouls] Law 8.1.
struct FoulRules {
  bool push = false;             ///< whether pushing away from the ball is called
  double push_seconds = 0.5;     ///< [s] that the contact must last
  double push_impulse = 0.04;    ///< [kg m/s] that it must give in all
  double push_speed = 0.10;      ///< [m/s] at which the other robot is moved at least
  double push_distance = 0.15;   ///< [m] from the ball to both robots' centres at least
  double push_release = 0.05;    ///< [s] without contact that end it
  double part_seconds = 0.5;     ///< [s] a robot that touched the ball this recently disputes it
  bool holding = false;          ///< whether pinning the ball to a wall by others than the keeper is called
  double pinned_seconds = 3.0;   ///< [s] that a robot may press an undisputed ball against a wall
  double pinned_speed = 0.1;     ///< [m/s] of ball and robot, up to which the ball is pinned
  double holding_release = 0.2;  ///< [s] without pinning that end it
  double dispute_lengths = 1.5;  ///< [robot lengths] an opponent this near to the ball disputes it
  double cool_down = 0.5;        ///< [s] after play began without a call of this law
};

}  // namespace fulbito
