#pragma once

#include <optional>
#include <span>

namespace fulbito::localization {

/// One echo of the front sensor while the robot turns in place.
struct SweepEcho {
  double heading = 0.0;        ///< [rad] robot's heading by its gyro, not wrapped
  std::optional<double> time;  ///< [s]
};

/// Properties of the front sensor for `fittedPerpendicular`.
struct SweepSensor {
  double cone = 0.218;        ///< [rad] half width of its cone
  double reach = 0.0;         ///< [m] from the robot's centre, about which the sensor turns
  double echo_speed = 170.0;  ///< [m/s] errors of a few per cent do not matter
  double noise = 0.008;       ///< [m] standard deviation of a range
};

/// The paper's rule: the heading of the shortest echo. Since a sensor hears a wall's perpendicular over the
/// whole width of its cone, noise decides which of many echoes is shortest. Empty without echoes.
std::optional<double> shortestEcho(std::span<const SweepEcho> sweep);

/// The middle of the headings whose ranges are within 5 % or 4 sigma of the shortest one. Empty without
/// echoes.
std::optional<double> levelCentre(std::span<const SweepEcho> sweep, const SweepSensor& sensor);

/// The perpendicular of a wall near `guess` by least squares over all echoes. Within the cone an echo comes
/// from the perpendicular, outside it from the cone's edge, so the range over the heading has a flat bottom
/// and two flanks. If another wall hides one flank, the other one is enough, unlike for `levelCentre`.
double fittedPerpendicular(std::span<const SweepEcho> sweep, double guess, const SweepSensor& sensor);

}  // namespace fulbito::localization
