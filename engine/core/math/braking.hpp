#pragma once

#include <cmath>

namespace fulbito {

/// Highest speed [m/s], or [rad/s], from which a body that slows down by `deceleration` > 0 [m/s^2], or
/// [rad/s^2], reaches `final_speed` within the distance `way` >= 0 [m], or [rad]: v^2 = v_f^2 + 2 a s.
inline double stoppingSpeed(double deceleration, double way, double final_speed = 0.0) {
  return std::sqrt(final_speed * final_speed + 2.0 * deceleration * way);
}

}  // namespace fulbito
