#pragma once

namespace fulbito {

/// The team with the first kick-off.
enum class FirstKickOff { kToss, kBlue, kYellow };

/// The tie-break after two halves.
enum class TieBreak {
  kNone,      ///< the match ends in a draw
  kOvertime,  ///< overtime; a draw is possible after it
  kShootOut,  ///< a shoot-out at once
  kBoth       ///< overtime, then a shoot-out
};

/// [periods] Laws 5 and 7.2. The length of a half is `Rules::half_seconds`.
struct PeriodRules {
  FirstKickOff first_kick_off = FirstKickOff::kToss;  ///< the toss uses the match's random stream
  bool swap_kick_off = true;                          ///< the other team kicks off in the second half
  bool swap_sides = false;                            ///< teams change sides at half-time
  int mercy_goals = 0;                                ///< lead that ends the match; 0 = never
  TieBreak tie_break = TieBreak::kNone;               ///< the tie-break after two halves
  int overtime_parts = 1;                             ///< periods of overtime
  double overtime_seconds = 180.0;                    ///< [s] play time of each overtime period
  bool golden_goal = true;                            ///< the first goal in overtime ends the match
};

/// The order of the kicks in a shoot-out.
enum class ShootOutOrder {
  kAlternating,  ///< one kick each in turn
  kSeries        ///< all regular kicks of one team, then of the other; sudden death in turn
};

/// [shoot_out] Law 7.2.
struct ShootOutRules {
  int kicks = 3;                                      ///< regular kicks per team; then sudden death in pairs
  ShootOutOrder order = ShootOutOrder::kAlternating;  ///< order of the kicks
  int max_kicks = 20;                                 ///< most kicks per team; then a toss decides
  double kick_seconds = 30.0;                         ///< [s] time limit of a kick
  bool ends_at_rest = true;                           ///< a kick ends when the ball is at rest
  double rest_speed = 0.02;                           ///< [m/s] a ball at most this fast is at rest
  double rest_seconds = 1.0;      ///< [s] time at rest that ends a kick, once the ball has moved
  double held_seconds = 0.5;      ///< [s] undisputed control by the keeper in its area that ends it; 0: never
  bool ends_leaving_area = true;  ///< a kick ends when the ball leaves the goal area backward
  bool ends_past_midfield = true;  ///< a kick ends when the ball crosses the half-way line backward
};

/// The consequence of an absent team.
enum class WalkOver {
  kPlay,    ///< the present team plays against the empty field
  kForfeit  ///< the match ends at once
};

/// [walk_over] Law 7.3.
struct WalkOverRules {
  WalkOver mode = WalkOver::kPlay;  ///< the consequence of an absent team
  double seconds = 180.0;           ///< [s] play time on the empty field
  int absent_score = -1;            ///< score of the absent team, minus the goals of the other
  int both_absent_score = -3;       ///< score of both teams if both are absent
};

}  // namespace fulbito
