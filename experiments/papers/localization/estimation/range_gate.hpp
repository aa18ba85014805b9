#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fulbito/models.hpp"

namespace fulbito::localization {

/// The paper's test of an echo (Fig. 3): its change since each of the last two echoes must agree with the
/// motion by encoders and gyro, up to a limit. There is one gate per sensor.
class RangeGate {
 public:
  /// @param limit  [m] the paper's l0
  explicit RangeGate(double limit) : limit_(limit) {}

  /// Tests a range [m], if there is one, measured from `sensor` along the unit vector `direction`, both in
  /// the frame of dead reckoning. @return whether the range may be used
  bool accept(std::optional<double> range, Vec2 sensor, Vec2 direction);

 private:
  struct Reading {
    std::optional<double> range;
    Vec2 sensor;
  };
  bool agrees(const Reading& now, const Reading& before, Vec2 direction) const;

  double limit_;
  std::array<Reading, 2> before_;  ///< last reading and the one before
};

}  // namespace fulbito::localization
