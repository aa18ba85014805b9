#include "experiments/papers/capture/motion_profile.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr int kPieces = 24;  // number of pieces of a phase with changing curvature

// Gains of the errors along the path, across it and in heading. At the speed v the error across the path
// follows an oscillator with the frequency sqrt(kAcross) v and the damping kTurn / (2 sqrt(kAcross)): 1.5 per
// metre and 0.83.
constexpr double kAlong = 0.8;    // [1/s]
constexpr double kAcross = 2.25;  // [1/m^2]
constexpr double kTurn = 2.5;     // [1/m]

Twist twistAt(const MotionPhase& phase, double share) {
  return {std::lerp(phase.from.linear, phase.to.linear, share),
          std::lerp(phase.from.angular, phase.to.angular, share)};
}

/// The pose at `share` of a phase.
Pose2 poseIn(const MotionPhase& phase, const Pose2& start, double share) {
  const double time = share * phase.duration;
  const double way = (phase.from.linear + twistAt(phase, share).linear) / 2 * time;
  const double skew = phase.from.linear * phase.to.angular - phase.to.linear * phase.from.angular;
  if (skew == 0.0) {  // speed and yaw rate stay proportional, or there is no turn
    const Twist& twist = std::abs(phase.to.linear) > std::abs(phase.from.linear) ? phase.to : phase.from;
    if (twist.linear != 0.0) return poseAt(Arc{start, twist.angular / twist.linear, 0.0}, way);
  }
  Pose2 pose = start;
  const double step = time / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    const Twist middle = twistAt(phase, share * (i + 0.5) / kPieces);
    const double heading = pose.heading + middle.angular * step / 2;
    pose.position += math::unit(heading) * (middle.linear * step);
    pose.heading += middle.angular * step;
  }
  pose.heading = math::wrapAngle(pose.heading);
  return pose;
}

}  // namespace

void MotionProfile::append(const MotionPhase& phase) {
  starts_.push_back(poseIn(phase, starts_.back(), 1.0));
  phases_.push_back(phase);
  duration_ += phase.duration;
}

MotionState MotionProfile::at(double time) const {
  double left = std::clamp(time, 0.0, duration_);
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const MotionPhase& phase = phases_[i];
    if (left >= phase.duration && i + 1 < phases_.size()) {
      left -= phase.duration;
      continue;
    }
    const double share = phase.duration > 0.0 ? std::min(left / phase.duration, 1.0) : 1.0;
    return {poseIn(phase, starts_[i], share), twistAt(phase, share)};
  }
  return {starts_.back(), {}};
}

Twist trackingTwist(const MotionState& reference, const Pose2& robot) {
  const Vec2 off = reference.pose.position - robot.position, ahead = math::unit(robot.heading);
  const math::SinCos turned = math::sinCos(math::wrapAngle(reference.pose.heading - robot.heading));
  const double speed = reference.twist.linear;
  return {speed * turned.cos + kAlong * dot(off, ahead),
          reference.twist.angular + speed * (kAcross * cross(ahead, off) + kTurn * turned.sin)};
}

}  // namespace fulbito::capture
