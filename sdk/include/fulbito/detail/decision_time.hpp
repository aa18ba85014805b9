#pragma once

namespace fulbito {

/// Limits of a team's time, in wall time. Time beyond `decision` comes from the bank. If the bank is too low,
/// the decision is late: it is rejected, and the previous one stays in force. A match with late decisions
/// depends on the speed of the machine; only its recording repeats it.
struct DecisionTime {
  double decision =
      0.02;           ///< [s] limit of each decision and of each placement, 0 ... 60; infinite: unlimited
  double bank = 2.0;  ///< [s] total time beyond it per period, 0 ... 3600
  /// Late decisions in a row for which the last command stays in force, 0 ... 3600; after more, the robots
  /// stop. The default is half a second at 60 Hz. A real robot stops its motors after about that time without
  /// radio.
  int held = 30;
  double start =
      10.0;  ///< [s] limit of the start of a team outside the program, and of each new start, 0 ... 600
  /// Failures after which a team outside the program forfeits the match, 1 ... 1000. A failure is the end of
  /// its program, a broken message, or a late start.
  int failures = 3;
};

}  // namespace fulbito
