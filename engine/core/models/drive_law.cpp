#include "engine/core/models/drive_law.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {

// With g the turn share, pulls l and r change the rims by ((1 + g) l + (1 - g) r) / 2 and the mirror image.
DriveLaw::DriveLaw(const RobotModel& robot, double dt)
    : limit_(robot.motorPull() * dt),
      drag_(robot.rolling_drag * dt),
      gain_(robot.wheel_acceleration * dt),
      loss_(robot.wheel_braking * dt),
      turn_(robot.turnShare()),
      own_((1.0 + turn_) / (2.0 * turn_)),
      other_((turn_ - 1.0) / (2.0 * turn_)),
      felt_((1.0 - turn_) / 2.0),
      per_pull_(2.0 / (1.0 + turn_)),
      widening_(robot.curve_widening / (robot.axle_track / 2)),
      rise_(robot.curve_widening_rise / (robot.axle_track / 2)) {}

// Coulomb: against the motion, or against the motion that is about to begin.
double DriveLaw::drag(double forward, double forward_target) const {
  if (forward != 0.0) return -std::clamp(forward, -drag_, drag_);
  return forward_target == 0.0 ? 0.0 : -std::copysign(drag_, forward_target);
}

RimSpeeds DriveLaw::pulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const {
  const double lost = drag((ground.left + ground.right) / 2, (target.left + target.right) / 2);
  const RimSpeeds lack{target.left - ground.left - lost, target.right - ground.right - lost};
  RimSpeeds pull{own_ * lack.left + other_ * lack.right, own_ * lack.right + other_ * lack.left};
  if (std::abs(pull.left) <= limits.left && std::abs(pull.right) <= limits.right) return pull;
  // If one motor is at its limit, the other one only controls its own rim.
  const auto limited = [&](double rim_lack, double other_pull, double limit) {
    return std::clamp((rim_lack - felt_ * other_pull) * per_pull_, -limit, limit);
  };
  if (std::abs(pull.left) * limits.right >= std::abs(pull.right) * limits.left) {
    pull.right = limited(lack.right, std::clamp(pull.left, -limits.left, limits.left), limits.right);
    pull.left = limited(lack.left, pull.right, limits.left);
  } else {
    pull.left = limited(lack.left, std::clamp(pull.right, -limits.right, limits.right), limits.left);
    pull.right = limited(lack.right, pull.left, limits.right);
  }
  return pull;
}

RimSpeeds DriveLaw::change(RimSpeeds ground, RimSpeeds target, RimSpeeds pulls) const {
  const double forward = (ground.left + ground.right) / 2;
  const double raw = (pulls.left + pulls.right) / 2 + drag(forward, (target.left + target.right) / 2);
  const double most = raw * forward < 0.0 ? loss_ : gain_;
  const double common = std::clamp(raw, -most, most);
  const double turn = turn_ * (pulls.right - pulls.left) / 2;
  return {common - turn, common + turn};
}

// With T = widening + rise |v|, a curve of radius v / w becomes one of v / w + T v: w' = w / (1 + T w).
double DriveLaw::widening(double forward) const { return widening_ + rise_ * std::abs(forward); }

RimSpeeds DriveLaw::reached(RimSpeeds commanded) const {
  if (widening_ == 0.0 && rise_ == 0.0) return commanded;
  const double common = (commanded.left + commanded.right) / 2, turn = (commanded.right - commanded.left) / 2;
  // Beyond a wheel that stands, |turn| > |common|, the share that is lost stays as it is there.
  const double felt = std::min(std::abs(turn), std::abs(common));
  const double left_over = turn / (1.0 + widening(common) * felt);
  return {common - left_over, common + left_over};
}

RimSpeeds DriveLaw::commandFor(RimSpeeds wanted) const {
  if (widening_ == 0.0 && rise_ == 0.0) return wanted;
  const double common = (wanted.left + wanted.right) / 2, turn = (wanted.right - wanted.left) / 2;
  const double most = 1.0 + widening(common) * std::abs(common);  // command over result beyond that wheel
  const bool curve = std::abs(turn) * most <= std::abs(common);
  const double needed = curve ? turn / (1.0 - widening(common) * std::abs(turn)) : turn * most;
  return {common - needed, common + needed};
}

}  // namespace fulbito
