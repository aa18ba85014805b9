#pragma once

#include "engine/sim/drive.hpp"

namespace fulbito {

/// How contacts move and turn a robot in each physics step for as long as they last. Motors and tyres act
/// before the contacts of a step are solved. If they only answered the motion that is left of the step
/// before, a lasting push would shift and turn the robot by its acceleration times the step, however well the
/// tyres hold. So they also answer what the contacts are about to do.
class LastingPush {
 public:
  /// The change by the contacts of the next step: nine tenths of the smaller of those of the last two steps.
  /// It is none for impacts, which last one step.
  const BodyMotion& expected() const { return expected_; }
  /// Looks at what the contacts of a step changed.
  /// @param before  motion after motors and tyres
  /// @param after  motion after the contacts
  void measure(const BodyMotion& before, const BodyMotion& after);

 private:
  BodyMotion last_;
  BodyMotion expected_;
};

}  // namespace fulbito
