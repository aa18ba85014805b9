#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fulbito/models.hpp"

namespace fulbito::localization {

/// The paper's test of an echo (Fig. 3): its change since the last and the last but one must be the way that
/// encoders and gyro saw, to a limit. One gate per sensor.
class RangeGate {
 public:
  /// @param limit  [m] the paper's l0
  explicit RangeGate(double limit) : limit_(limit) {}

  /// Takes in a range [m], or none, seen from `sensor` toward the unit vector `direction`, both in the frame
  /// of dead reckoning. @return whether it may be used
  bool accept(std::optional<double> range, Vec2 sensor, Vec2 direction);

 private:
  struct Reading {
    std::optional<double> range;
    Vec2 sensor;
  };
  bool agrees(const Reading& now, const Reading& before, Vec2 direction) const;

  double limit_;
  std::array<Reading, 2> before_;  ///< last, last but one
};

}  // namespace fulbito::localization
