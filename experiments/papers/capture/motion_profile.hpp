#pragma once

#include <vector>

#include "fulbito/models.hpp"

namespace fulbito::capture {

/// A piece of a motion: speed and yaw rate change linearly over its time.
struct MotionPhase {
  double duration = 0.0;  ///< [s]
  Twist from;             ///< at its beginning
  Twist to;               ///< at its end
};

/// A moment of a motion.
struct MotionState {
  Pose2 pose;
  Twist twist;
};

/// A motion from a pose through phases. Phases of constant curvature are exact arcs.
class MotionProfile {
 public:
  MotionProfile() : MotionProfile(Pose2{}) {}
  explicit MotionProfile(const Pose2& start) : starts_{start} {}
  void append(const MotionPhase& phase);
  /// The state `time` [s] after the start, which is clamped to the motion.
  MotionState at(double time) const;
  MotionState end() const { return at(duration()); }
  double duration() const { return duration_; }  ///< [s]

 private:
  std::vector<MotionPhase> phases_;
  std::vector<Pose2> starts_;  ///< of each phase, and the end
  double duration_ = 0.0;
};

/// The twist that brings a robot onto a moving reference: Kanayama et al. (1990). Across the way the error
/// falls as that of a damped oscillator over the distance driven.
Twist trackingTwist(const MotionState& reference, const Pose2& robot);

}  // namespace fulbito::capture
