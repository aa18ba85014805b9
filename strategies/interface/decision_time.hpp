#pragma once

namespace fulbito {

/// How long a team may think, in wall time. What a decision takes beyond `decision` is paid from the bank;
/// when the bank cannot pay, the decision is late: it is not carried out, and the one before holds. A match
/// with such a limit depends on the speed of the machine; only its recording repeats it.
struct DecisionTime {
  double decision = 0.02;  ///< [s] that every decision may take, 0 ... 60
  double bank = 2.0;       ///< [s] beyond it, in all, in each period, 0 ... 3600
  /// Late decisions in a row for which the last command holds, 0 ... 3600; from the next one on the robots
  /// stand. Half a second at 60 Hz: about what the radio of a real robot waits before it stops the motors.
  int held = 30;
};

}  // namespace fulbito
