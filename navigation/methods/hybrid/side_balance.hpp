#pragma once

#include <span>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// How far a robot in a narrow passage is off its middle, from pairs of sonars that look left and right
/// alike. Single ranges are too noisy to centre a body that fits by a few millimetres, so the difference is
/// smoothed.
class SideBalance {
 public:
  void reset() { offset_ = 0.0, silent_ = kForgotten; }
  /// Takes in one tick's readings, from left to right.
  /// @param beside  [m] both sonars of a pair hear something nearer than that: the robot is in a passage
  void update(std::span<const RangeReading> readings, double beside);
  /// Distance [m] to the right of the middle, negative to the left; 0 outside of a passage.
  double offset() const { return silent_ < kForgotten ? offset_ : 0.0; }

 private:
  static constexpr int kForgotten = 12;  // ticks without a pair until the offset is forgotten

  double offset_ = 0.0;
  int silent_ = kForgotten;
};

}  // namespace fulbito
