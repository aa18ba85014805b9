#include "engine/core/models/drive_law.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {

// With g the turn share, pulls l and r change the rims by ((1 + g) l + (1 - g) r) / 2 and the mirror image.
DriveLaw::DriveLaw(const RobotModel& robot, double dt)
    : limit_(robot.motorPull() * dt),
      drag_(robot.rolling_drag * dt),
      most_{robot.wheel_acceleration * dt, robot.wheel_braking * dt},
      turn_(robot.turnShare()),
      own_((1.0 + turn_) / (2.0 * turn_)),
      other_((turn_ - 1.0) / (2.0 * turn_)),
      felt_((1.0 - turn_) / 2.0),
      per_pull_(2.0 / (1.0 + turn_)),
      edges_(robot.wheel_width / robot.axle_track),
      scrub_(turn_ * robot.wheel_width / (2.0 * robot.axle_track)),
      grip_(2.0 * robot.longitudinal_grip * dt),
      resisted_(robot.rolling_drag > 0.0 || robot.wheel_width > 0.0),
      widening_(robot.curve_widening / (robot.axle_track / 2)),
      rise_(robot.curve_widening_rise / (robot.axle_track / 2)) {}

// Each wheel seeks the nearest speed at which one of its edges rolls, given the other wheel's pull, the drag
// and the scrubbing, which depend on both pulls. The coupling of the wheels is weak, so that a few rounds
// settle. Both wheels look at the round before, so that a mirrored motion has mirrored pulls to the last bit.
RimSpeeds DriveLaw::resistedPulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const {
  constexpr int kMostRounds = 16;
  constexpr double kSettled = 1e-6;  // [m/s]
  const double forward = (ground.left + ground.right) / 2, turn = (ground.right - ground.left) / 2;
  const double play = edges_ * std::abs(turn);
  const auto lack = [play](double rim, double aim) { return std::clamp(rim, aim - play, aim + play) - rim; };
  // What a robot without drag and scrubbing needs, if its motors are strong enough.
  const double left = lack(ground.left, target.left), right = lack(ground.right, target.right);
  RimSpeeds pull{std::clamp(own_ * left + other_ * right, -limits.left, limits.left),
                 std::clamp(own_ * right + other_ * left, -limits.right, limits.right)};
  for (int round = 0; round < kMostRounds; ++round) {
    const RimSpeeds before = pull;
    const double sum = (before.left + before.right) / 2;
    const double drag = -std::clamp(forward + sum, -drag_, drag_), braked = scrub(turn, before);
    const auto towards = [&](double rim, double aim, double limit) {
      return std::clamp(lack(rim, aim) * per_pull_, -limit, limit);
    };
    pull.left = towards(ground.left + drag - braked + felt_ * before.right, target.left, limits.left);
    pull.right = towards(ground.right + drag + braked + felt_ * before.left, target.right, limits.right);
    if (std::abs(pull.left - before.left) + std::abs(pull.right - before.right) < kSettled) break;
  }
  return pull;
}

// With T = widening + rise |v|, a curve of radius v / w becomes one of v / w + T v: w' = w / (1 + T w).
double DriveLaw::widening(double forward) const { return widening_ + rise_ * std::abs(forward); }

RimSpeeds DriveLaw::reachedInCurve(RimSpeeds commanded) const {
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
