#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// Readings of one range sensor over a few ticks as one: the error of the mean falls with their root.
struct SmoothRange {
  Vec2 apex;  ///< [m] world frame: where the sensor was on average
  Vec2 axis;  ///< unit, world frame
  double half_cone = 0.0;
  bool heard = false;
  double range = 0.0;  ///< [m] from `apex`; the sensor's greatest range where it heard nothing
};

/// Averages the last readings of one sensor, whose pose is known. A line over time is fitted to the ranges:
/// where they jump from one surface to another, or change faster than a robot drives, there is no answer.
class RangeSmoother {
 public:
  static constexpr std::size_t kReadings = 9;

  void reset() { count_ = 0; }
  /// Takes in one tick's reading; empty until the window is full, and where the readings do not agree.
  /// @param pose  of the robot
  std::optional<SmoothRange> add(const RangeReading& reading, const Pose2& pose);
  /// Mean [m] of what was heard in the last four ticks, for quick reactions; empty where it was fewer than
  /// two.
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
