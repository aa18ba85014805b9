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
  /// @param beside  [m] something is nearer than that on the left and on the right: the robot is in a passage
  void update(std::span<const RangeReading> readings, double beside);
  /// Half of what the left has more than the right [m]; 0 outside of a passage.
  double offset() const { return inPassage() ? offset_ : 0.0; }
  /// Whether something was near on both sides just now.
  bool inPassage() const { return silent_ < kForgotten; }

 private:
  static constexpr int kForgotten = 12;  // ticks outside of a passage until the offset is forgotten

  double offset_ = 0.0;
  int silent_ = kForgotten;
};

}  // namespace fulbito
