#pragma once

#include <string_view>

namespace fulbito {

/// The outcome of a navigation trial.
enum class TrialOutcome {
  kReached,    ///< arrived (with the wanted heading, if any) without a forbidden contact
  kCollided,   ///< made a forbidden contact; the trial continues, so that the rest of the score is known
  kStuck,      ///< did not move or turn for `TrialRules::stuck_after`
  kTimedOut,   ///< did not arrive before the time ran out
  kLeftField,  ///< its centre left the field
};

/// Name of an outcome in tables and files: reached, collided, stuck, timed-out, left-field.
std::string_view nameOf(TrialOutcome outcome);

/// The contacts that a trial forbids.
enum class ForbiddenContacts {
  kAll,        ///< contacts with obstacles or walls
  kObstacles,  ///< contacts with obstacles only, for suites that start at a wall
  kOwnMotion,  ///< only obstacles that the robot drove into, see TrialScore::own_contacts
};

/// The figures of one navigation trial.
struct TrialScore {
  TrialOutcome outcome = TrialOutcome::kTimedOut;  ///< the trial's outcome
  bool arrived = false;                            ///< reached the goal, even after a contact
  double time = 0.0;  ///< [s] until arrival, interpolated within the last tick, or until the end of the trial
  double length = 0.0;        ///< [m] length of the driven path
  double length_limit = 0.0;  ///< [m] L*, shortest possible
  double time_limit = 0.0;    ///< [s] T*, see timeBound
  int obstacle_contacts = 0;  ///< contacts with obstacles that began
  int wall_contacts = 0;      ///< contacts with walls that began
  int own_contacts = 0;  ///< of the obstacle contacts: the robot moved faster than 2 cm/s toward the contact
                         ///< point, and no obstacle had pushed it in the half second before
  double contact_impulse = 0.0;  ///< [kg m/s] sum over all contacts
  double min_clearance = 0.0;    ///< [m] least distance of the body to obstacles and walls
  double mean_clearance = 0.0;   ///< [m] mean over time
  double turning = 0.0;          ///< [rad] sum of |change of heading|
  int curvature_jumps =
      0;  ///< ticks at which the driven curvature changed by more than 10 /m at over 0.1 m/s
  double wheel_jerk = 0.0;     ///< [m/s^3] RMS of the commanded rim speeds' second difference
  double heading_error = 0.0;  ///< [rad] at arrival, where a heading is wanted; else 0
  double longest_stuck = 0.0;  ///< [s] longest time without moving 1 cm or turning 20 degrees

  /// Whether the trial counts as solved.
  bool success() const { return outcome == TrialOutcome::kReached; }
  /// Length of the driven path over the shortest possible: 1 is perfect.
  double lengthRatio() const { return length / length_limit; }
  /// Time over the least possible: 1 is perfect.
  double timeRatio() const { return time / time_limit; }
};

/// Least time [s] for `length` [m] from rest without a stop at the end: `L/v + v/2a`, or `sqrt(2L/a)` if the
/// robot does not reach its top speed (docs/scoring.md; the run time of Choi & Lee 2005).
double timeBound(double length, double max_speed, double acceleration);

}  // namespace fulbito
