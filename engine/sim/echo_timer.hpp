#pragma once

#include <cstdint>

namespace fulbito {

/// Speed of sound [m/s] in dry air of `celsius` [degrees], at least -273.15: 331.3 m/s times the root of the
/// absolute temperature over that of melting ice.
double speedOfSound(double celsius);

/// Times echoes as an ultrasonic sensor's counter does: whole microseconds from the pulse to its echo. It
/// knows no temperature; who reads it turns time into distance.
class EchoTimer {
 public:
  /// @param celsius  temperature of the air; it must have a speed of sound above 0
  explicit EchoTimer(double celsius) : per_metre_(2e6 / speedOfSound(celsius)) {}

  /// The count [us] for a wall `range` [m] away, which is finite; 0 for a negative range.
  std::int64_t microseconds(double range) const;

 private:
  double per_metre_;  // [us/m] there and back
};

}  // namespace fulbito
