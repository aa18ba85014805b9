#pragma once

namespace fulbito {

/// Which team begins a period.
enum class FirstKickOff { kToss, kBlue, kYellow };

/// What follows a match that is level after two halves.
enum class TieBreak {
  kNone,      ///< it is a draw
  kOvertime,  ///< overtime; a draw when it is level after that
  kShootOut,  ///< a shoot-out at once
  kBoth       ///< overtime, then a shoot-out
};

/// [periods] Laws 5 and 7.2. The length of a half is `Rules::half_seconds`.
struct PeriodRules {
  FirstKickOff first_kick_off = FirstKickOff::kToss;  ///< toss: from the match's own random stream
  bool swap_kick_off = true;                          ///< the other team begins the second half
  bool swap_sides = false;                            ///< sides change at half-time
  int mercy_goals = 0;                                ///< lead that ends the match; 0 = none does
  TieBreak tie_break = TieBreak::kNone;
  int overtime_parts = 1;           ///< periods of overtime
  double overtime_seconds = 180.0;  ///< [s] of play in each
  bool golden_goal = true;          ///< the first goal of the overtime ends the match
};

/// In which order the kicks of a shoot-out are taken.
enum class ShootOutOrder {
  kAlternating,  ///< one kick each in turn
  kSeries        ///< all regular kicks of one team, then of the other; sudden death in turn
};

/// [shoot_out] Law 7.2.
struct ShootOutRules {
  int kicks = 3;  ///< regular kicks of each team; then sudden death in pairs
  ShootOutOrder order = ShootOutOrder::kAlternating;
  int max_kicks = 20;          ///< of each team; then the toss decides
  double kick_seconds = 30.0;  ///< [s] a kick lasts at most
  bool ends_at_rest = true;    ///< a kick ends when the ball rests
  double rest_speed = 0.02;    ///< [m/s] at most this is rest
  double rest_seconds = 1.0;   ///< [s] of rest that end the kick, once the ball has been moved
  double held_seconds = 0.5;   ///< [s] of undisputed control by the keeper in its area that end it; 0: none
  bool ends_leaving_area = true;   ///< a kick ends when the ball leaves the goal area again, backwards
  bool ends_past_midfield = true;  ///< a kick ends when the ball passes the half-way line backwards
};

/// What happens when a team is not there.
enum class WalkOver {
  kPlay,    ///< the present team plays against the empty field
  kForfeit  ///< the match ends at once
};

/// [walk_over] Law 7.3.
struct WalkOverRules {
  WalkOver mode = WalkOver::kPlay;
  double seconds = 180.0;  ///< [s] of play against the empty field
  int absent_score = -1;   ///< of the absent team, less the goals that the present one reaches
  int both_absent_score = -3;
};

}  // namespace fulbito
