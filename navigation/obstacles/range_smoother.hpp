#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// Mean of the readings of one range sensor over a few ticks. Its error falls with the root of their number.
struct SmoothRange {
  Vec2 apex;  ///< [m] mean position of the sensor, world frame
  Vec2 axis;  ///< unit vector along the cone's axis, world frame
  double half_cone = 0.0;
  bool heard = false;
  double range = 0.0;  ///< [m] from `apex`; the sensor's greatest range if there was no echo
};

/// Averages the last readings of one sensor with a known pose. It fits a line over time to the ranges. It
/// gives no result if they jump between surfaces or change faster than a robot drives.
class RangeSmoother {
 public:
  static constexpr std::size_t kReadings = 9;

  void reset() { count_ = 0; }
  /// Adds the reading of one tick. Empty until the window is full, or if the readings do not agree.
  /// @param pose  the robot's pose
  std::optional<SmoothRange> add(const RangeReading& reading, const Pose2& pose);
  /// Mean [m] of the echoes in the last four ticks, for quick reactions; empty if there were fewer than two.
  std::optional<double> recent() const;

 private:
  struct Item {
    Vec2 apex;
    double heading = 0.0;
    bool heard = false;
    double range = 0.0;
  };
  const Item& item(std::size_t age) const { return ring_[(count_ - 1 - age) % kReadings]; }
  bool agree(const SmoothRange& mean, double mean_age, int heard) const;

  std::array<Item, kReadings> ring_;
  std::size_t count_ = 0;
};

}  // namespace fulbito
