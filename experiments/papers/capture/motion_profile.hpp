#pragma once

#include <vector>

#include "fulbito/models.hpp"

namespace fulbito::capture {

/// A piece of a motion in which speed and yaw rate change linearly with time.
struct MotionPhase {
  double duration = 0.0;  ///< [s]
  Twist from;             ///< at its beginning
  Twist to;               ///< at its end
};

/// The state of a motion at one time.
struct MotionState {
  Pose2 pose;
  Twist twist;
};

/// A motion from a pose through phases. Phases with constant curvature are exact arcs.
class MotionProfile {
 public:
  MotionProfile() : MotionProfile(Pose2{}) {}
  explicit MotionProfile(const Pose2& start) : starts_{start} {}
  void append(const MotionPhase& phase);
  /// The state `time` [s] after the start; times outside the motion are clamped.
  MotionState at(double time) const;
  MotionState end() const { return at(duration()); }
  double duration() const { return duration_; }  ///< [s]

 private:
  std::vector<MotionPhase> phases_;
  std::vector<Pose2> starts_;  ///< start poses of the phases, and the end pose
  double duration_ = 0.0;
};

/// The twist that brings a robot onto a moving reference: Kanayama et al. (1990). The error across the path
/// decays over distance like a damped oscillator.
Twist trackingTwist(const MotionState& reference, const Pose2& robot);

}  // namespace fulbito::capture
