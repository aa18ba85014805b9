#pragma once

#include <vector>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// [restart] All restarts: the time to the signal and law 9, the false start.
struct RestartRules {
  double delay = 0.5;                  ///< [s] from the placement to the signal
  double goal_delay = 0.5;             ///< [s] from the placement to the signal after a goal
  bool hold_robots = true;             ///< robots cannot move before the signal
  double robot_gap = 0.005;            ///< [m] least gap between placed bodies
  double false_start_distance = 0.02;  ///< [m] a robot this far from its place has moved
  double false_start_release = 0.015;  ///< [m] a robot nearer than this is back: hysteresis
  double false_start_seconds = 0.1;    ///< [s] a robot must be away for this long
  bool escalation = true;              ///< law 9 escalates after the warnings; otherwise endless repeats
  int warnings = 1;                    ///< repeats without a penalty
  int max_repeats = 10;         ///< after this many false starts at a restart, the signal comes at once
  double card_seconds = 30.0;   ///< [s] play time of a robot's exclusion
  bool card_until_goal = true;  ///< a goal brings it back earlier
};

/// Robot centres by number [m] for a team that defends the goal at +x; otherwise x is negated. Robots beyond
/// the list get the nearest free places.
struct PlaceTable {
  std::vector<Vec2> taker;  ///< the team that takes the restart
  std::vector<Vec2> other;  ///< the other team
};

/// [kick_off] Law 6.
struct KickOffRules {
  PlaceTable places{{{0.675, 0.0}, {0.20, 0.0}, {0.40, 0.0}},
                    {{0.675, 0.0}, {0.20, 0.0}, {0.40, 0.0}}};  ///< places of the robots
  double circle_margin = 0.0;  ///< [m] distance of the other team's robot centres from the circle
};

/// The places at a free ball of robots that are not near the mark.
enum class FreeBallOthers {
  kStay,  ///< robots stay at their present places
  kTable  ///< the table places all robots
};

/// [free_ball] Law 14.
struct FreeBallRules {
  FreeBallOthers others = FreeBallOthers::kStay;  ///< places of the robots that take no mark
  double distance = 0.20;                         ///< [m] least distance of robot centres from the ball
  bool take_marks = true;  ///< one robot of each team goes to its mark, `distance` from the ball
  PlaceTable places{{{0.675, 0.0}, {-0.175, 0.40}, {-0.10, -0.20}},
                    {{0.675, 0.0}, {0.575, 0.40}, {0.30, -0.10}}};
};

/// [free_kick] Law 11.
struct FreeKickRules {
  double mark = 0.375;  ///< [m] x of the ball in the attacked half; the law gives no number
  double touch = 0.01;  ///< [m] a defender this close touches the line of its area
  PlaceTable places{{{0.675, 0.0}, {-0.30, 0.0}, {0.10, 0.40}},
                    {{0.7125, 0.0}, {0.5625, 0.20}, {0.5625, -0.20}}};
};

/// [penalty] Law 12. The mark is the field's.
struct PenaltyRules {
  double keeper_line = 0.005;  ///< [m] largest distance of the keeper's rear from the goal line
  PlaceTable places{{{0.65, 0.0}, {-0.30, 0.0}, {0.10, 0.40}},
                    {{0.7125, 0.0}, {-0.10, 0.25}, {-0.10, -0.40}}};
};

/// The sign of y of the ball at a goal kick, unless the team chooses.
enum class GoalKickSide {
  kOpen,   ///< the side farther from the nearest opponent; if equal, the keeper's
  kKeeper  ///< the side of the taking team's keeper
};

/// Places of the opponents at a goal kick; always outside the area.
enum class GoalKickOpponents {
  kOwnHalf,     ///< in their own half
  kOutsideArea  ///< anywhere else
};

/// [goal_kick] Law 13.
struct GoalKickRules {
  Vec2 ball{0.60, 0.35};                    ///< [m] in the taker's half; the sign of y comes from `side`
  GoalKickSide side = GoalKickSide::kOpen;  ///< side of the goal area
  bool ball_free = true;                    ///< the taking team may place the ball anywhere in its goal area
  GoalKickOpponents opponents = GoalKickOpponents::kOwnHalf;  ///< places of the other team
  PlaceTable places{{{0.675, 0.27}, {0.45, 0.32}, {0.30, -0.47}},
                    {{0.675, 0.0}, {0.225, 0.10}, {0.15, -0.32}}};
};

}  // namespace fulbito
