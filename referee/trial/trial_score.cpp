#include "fulbito/detail/trial_score.hpp"

#include <cmath>

namespace fulbito {

std::string_view nameOf(TrialOutcome outcome) {
  switch (outcome) {
    case TrialOutcome::kReached:
      return "reached";
    case TrialOutcome::kCollided:
      return "collided";
    case TrialOutcome::kStuck:
      return "stuck";
    case TrialOutcome::kTimedOut:
      return "timed-out";
    case TrialOutcome::kLeftField:
      return "left-field";
  }
  return "unknown";
}

double timeBound(double length, double max_speed, double acceleration) {
  const double ramp = max_speed * max_speed / (2.0 * acceleration);
  if (length < ramp) return std::sqrt(2.0 * length / acceleration);
  return length / max_speed + max_speed / (2.0 * acceleration);
}

}  // namespace fulbito
