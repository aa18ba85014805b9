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

namespace {

// The x for which the two rows, times x, are y.
RimSpeeds solved(RimSpeeds left, RimSpeeds right, RimSpeeds y) {
  const double scale = 1.0 / (left.left * right.right - left.right * right.left);
  return {(y.left * right.right - left.right * y.right) * scale,
          (y.right * left.left - right.left * y.left) * scale};
}

// The share of a step at which a pull turns round or comes to its limit.
double shareToKink(double pull, double step, double limit) {
  if (step == 0.0) return 1.0;
  return pull * step < 0.0 ? -pull / step : (limit - std::abs(pull)) / std::abs(step);
}

}  // namespace

// Each wheel seeks the nearest speed at which one of its edges rolls, given the other wheel's pull, the drag
// and the scrubbing, which depend on both pulls. All of it is linear in pieces: Newton's method is there once
// it has met the right piece. Both wheels are treated alike, so that a mirrored motion has mirrored pulls to
// the last bit.
RimSpeeds DriveLaw::resistedPulls(RimSpeeds ground, RimSpeeds target, RimSpeeds limits) const {
  constexpr int kNewtonRounds = 6, kMostRounds = 20;
  constexpr double kSettled = 1e-6;   // [m/s]
  constexpr double kHolds = -0.4999;  // just less than what leaves open how fast a robot pulls that stays
  const double forward = (ground.left + ground.right) / 2, turn = (ground.right - ground.left) / 2;
  const double play = edges_ * std::abs(turn);
  const auto lack = [play](double rim, double aim) { return std::clamp(rim, aim - play, aim + play) - rim; };
  // What a robot needs that all of the drag and the scrubbing brakes, if its motors are strong enough.
  const double slowed = -std::clamp(forward, -drag_, drag_), idle = scrub(turn, {});
  const double left = lack(ground.left + slowed - idle, target.left);
  const double right = lack(ground.right + slowed + idle, target.right);
  RimSpeeds pull{std::clamp(own_ * left + other_ * right, -limits.left, limits.left),
                 std::clamp(own_ * right + other_ * left, -limits.right, limits.right)};
  for (int round = 0; round < kMostRounds; ++round) {
    const RimSpeeds before = pull;
    const double moved = forward + (before.left + before.right) / 2;
    const double drag = -std::clamp(moved, -drag_, drag_), braked = scrub(turn, before);
    const RimSpeeds wanted{
        lack(ground.left + drag - braked + felt_ * before.right, target.left) * per_pull_,
        lack(ground.right + drag + braked + felt_ * before.left, target.right) * per_pull_};
    const RimSpeeds next{std::clamp(wanted.left, -limits.left, limits.left),
                         std::clamp(wanted.right, -limits.right, limits.right)};
    const RimSpeeds off{next.left - before.left, next.right - before.right};
    if (std::abs(off.left) + std::abs(off.right) < kSettled) return next;
    // How a change of either pull changes what each wheel seeks, if nothing limits it.
    const double left_slope = next.left == wanted.left && wanted.left != 0.0 ? per_pull_ : 0.0;
    const double right_slope = next.right == wanted.right && wanted.right != 0.0 ? per_pull_ : 0.0;
    pull = next;
    if (round >= kNewtonRounds || left_slope + right_slope == 0.0) continue;
    const double held = std::abs(moved) < drag_ ? kHolds : 0.0;
    const double scrubs = std::abs(braked) < std::abs(turn) ? std::copysign(scrub_, turn) : 0.0;
    const double by_left = std::copysign(scrubs, scrubs * before.left);
    const double by_right = std::copysign(scrubs, scrubs * before.right);
    const RimSpeeds step =
        solved({1.0 + left_slope * (held - by_left), left_slope * (held - by_right + felt_)},
               {right_slope * (held + by_left + felt_), 1.0 + right_slope * (held + by_right)}, off);
    double share = 1.0;  // as a robot that stays leaves its pulls open, such a step is very long
    if (held != 0.0)
      share = std::min({1.0, shareToKink(before.left, step.left, limits.left),
                        shareToKink(before.right, step.right, limits.right)});
    pull = {std::clamp(before.left + share * step.left, -limits.left, limits.left),
            std::clamp(before.right + share * step.right, -limits.right, limits.right)};
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
