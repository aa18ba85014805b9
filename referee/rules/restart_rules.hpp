#pragma once

#include <vector>

#include "engine/core/base/vec2.hpp"

namespace fulbito {

/// [restart] What all restarts share: the time to the signal and law 9, the false start.
struct RestartRules {
  double delay = 0.5;                  ///< [s] from the placement to the signal
  double goal_delay = 0.5;             ///< [s] the same after a goal
  bool hold_robots = true;             ///< nobody can move before the signal
  double robot_gap = 0.005;            ///< [m] between two bodies that are placed
  double false_start_distance = 0.02;  ///< [m] from its place: a robot has moved
  double false_start_release = 0.015;  ///< [m] nearer than this it is back: hysteresis
  double false_start_seconds = 0.1;    ///< [s] that it must be away
  bool escalation = true;              ///< after the warnings law 9 escalates; else repeats without end
  int warnings = 1;                    ///< repeats without punishment
  int max_repeats = 10;                ///< false starts at one restart after which the signal comes at once
  double card_seconds = 30.0;          ///< [s] of play that a robot stays out
  bool card_until_goal = true;         ///< a goal brings it back sooner
};

/// Centres of a team's robots by number [m], for the team that defends the goal at +x; the other team's x is
/// negated. Robots beyond the list get the nearest free places.
struct PlaceTable {
  std::vector<Vec2> taker;  ///< of the team that takes the restart
  std::vector<Vec2> other;
};

/// [kick_off] Law 6.
struct KickOffRules {
  PlaceTable places{{{0.675, 0.0}, {0.20, 0.0}, {0.40, 0.0}}, {{0.675, 0.0}, {0.20, 0.0}, {0.40, 0.0}}};
  double circle_margin = 0.0;  ///< [m] that centres of the other team's robots stay off the circle
};

/// What law 14 leaves to the robots that are not near the mark.
enum class FreeBallOthers {
  kStay,  ///< they stay where they are
  kTable  ///< all are placed anew
};

/// [free_ball] Law 14.
struct FreeBallRules {
  FreeBallOthers others = FreeBallOthers::kStay;
  double distance = 0.20;  ///< [m] of every robot's centre from the ball at least
  bool take_marks = true;  ///< one robot of each team goes to its mark, `distance` from the ball
  PlaceTable places{{{0.675, 0.0}, {-0.175, 0.40}, {-0.10, -0.20}},
                    {{0.675, 0.0}, {0.575, 0.40}, {0.30, -0.10}}};
};

/// [free_kick] Law 11.
struct FreeKickRules {
  double mark = 0.375;  ///< [m] from the centre along x, in the attacked half; the law gives no number
  double touch = 0.01;  ///< [m] a defender this near touches the line of its area
  PlaceTable places{{{0.675, 0.0}, {-0.30, 0.0}, {0.10, 0.40}},
                    {{0.7125, 0.0}, {0.5625, 0.20}, {0.5625, -0.20}}};
};

/// [penalty] Law 12. The mark is the field's.
struct PenaltyRules {
  double keeper_line = 0.005;  ///< [m] the keeper's rear may be off the goal line by this
  PlaceTable places{{{0.65, 0.0}, {-0.30, 0.0}, {0.10, 0.40}},
                    {{0.7125, 0.0}, {-0.10, 0.25}, {-0.10, -0.40}}};
};

/// On which side of y the ball of a goal kick lies unless its team chooses.
enum class GoalKickSide {
  kOpen,   ///< where the nearest opponent was farther off; between equals the keeper's
  kKeeper  ///< where the taking team's keeper was
};

/// Where the other team stands at a goal kick, outside the area in any case.
enum class GoalKickOpponents {
  kOwnHalf,     ///< in its own half
  kOutsideArea  ///< anywhere else
};

/// [goal_kick] Law 13.
struct GoalKickRules {
  Vec2 ball{0.60, 0.35};  ///< [m] in the taker's half; the sign of y comes from `side`
  GoalKickSide side = GoalKickSide::kOpen;
  bool ball_free = true;  ///< the taking team may choose another place in its goal area
  GoalKickOpponents opponents = GoalKickOpponents::kOwnHalf;
  PlaceTable places{{{0.675, 0.27}, {0.45, 0.32}, {0.30, -0.47}},
                    {{0.675, 0.0}, {0.225, 0.10}, {0.15, -0.32}}};
};

}  // namespace fulbito
