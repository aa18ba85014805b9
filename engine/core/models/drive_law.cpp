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

// The solution x of the equation y = M x, where M has the elements `on` on its diagonal, else `beside`.
WheelPair solved(WheelPair on, WheelPair beside, WheelPair y) {
  const WheelPair scale = WheelPair(1.0) / (on * on.swapped() - beside * beside.swapped());
  return (y * on.swapped() - beside * y.swapped()) * scale;
}

// The share of `step` after which `pull` changes its sign or reaches `limit`.
double shareToKink(double pull, double step, double limit) {
  if (step == 0.0) return 1.0;
  return pull * step < 0.0 ? -pull / step : (limit - std::abs(pull)) / std::abs(step);
}

// The smaller share of both pulls, at most 1.
double shareToKink(WheelPair pull, WheelPair step, WheelPair limits) {
  return std::min({1.0, shareToKink(pull.left(), step.left(), limits.left()),
                   shareToKink(pull.right(), step.right(), limits.right())});
}

}  // namespace

// Each motor seeks the nearest rim speed at which one edge of its wheel rolls. The other motor's pull, the
// drag and the scrubbing also change the rim, and the last two depend on both pulls. All of this is piecewise
// linear: Newton's method is exact once it has found the right piece. Both wheels are treated alike, so
// mirrored motions have mirrored pulls to the last bit.
WheelPair DriveLaw::resistedPulls(WheelPair ground, WheelPair target, WheelPair limits) const {
  constexpr int kNewtonRounds = 6, kMostRounds = 20;
  constexpr double kSettled = 1e-6;  // [m/s]
  // The drag's derivative by a pull at rest: -1/2 itself would make the matrix singular
  constexpr double kHolds = -0.4999;
  const WheelPair half(0.5), most_drag(drag_), felt(felt_), per_pull(per_pull_);
  const WheelPair forward = half * ground.sum(), turn(0.5 * (ground.right() - ground.left()));
  const WheelPair play = WheelPair(edges_) * turn.abs(), slowest = target - play, fastest = target + play;
  const auto lack = [&](WheelPair rim) { return rim.clamped(slowest, fastest) - rim; };
  // First guess: drag and scrubbing act in full, and no motor is at its limit.
  const WheelPair slowed = ground - forward.clamped(-most_drag, most_drag);
  const WheelPair needed = lack(slowed + scrub(turn, WheelPair(0.0)).mirrored());
  WheelPair pull = (WheelPair(own_) * needed + WheelPair(other_) * needed.swapped()).clamped(-limits, limits);
  for (int round = 0; round < kMostRounds; ++round) {
    const WheelPair before = pull, moved = forward + half * before.sum();
    const WheelPair braked = scrub(turn, before);
    const WheelPair dragged = ground - moved.clamped(-most_drag, most_drag) + braked.mirrored();
    const WheelPair wanted = lack(dragged + felt * before.swapped()) * per_pull;
    const WheelPair next = wanted.clamped(-limits, limits), off = next - before;
    pull = next;
    if (off.abs().sum().left() < kSettled) break;
    // Derivatives of each motor's wanted pull by both pulls, where no limit applies.
    const WheelPair slope = per_pull.whereEqual(next, wanted).whereAny(wanted);
    if (round >= kNewtonRounds || slope.sum().left() == 0.0) continue;
    const WheelPair held = WheelPair(kHolds).whereBelow(moved.abs(), most_drag);
    const WheelPair scrubs = WheelPair(scrub_).withSign(turn).whereBelow(braked.abs(), turn.abs());
    const WheelPair by = scrubs.withSign(scrubs * before);
    const WheelPair step = solved(WheelPair(1.0) + slope * (held + by.mirrored()),
                                  slope * (held + by.swapped().mirrored() + felt), off);
    // At rest the pulls are nearly undetermined, and the step can be very long.
    const WheelPair share(held.left() != 0.0 ? shareToKink(before, step, limits) : 1.0);
    pull = (before + share * step).clamped(-limits, limits);
  }
  return pull;
}

// With T = widening + rise |v|, a curve of radius v / w becomes one of v / w + T v: w' = w / (1 + T w).
double DriveLaw::widening(double forward) const { return widening_ + rise_ * std::abs(forward); }

RimSpeeds DriveLaw::reachedInCurve(RimSpeeds commanded) const {
  const double common = (commanded.left + commanded.right) / 2, turn = (commanded.right - commanded.left) / 2;
  // In tighter curves, |turn| > |common|, the lost share stays that of a curve about a standing wheel.
  const double felt = std::min(std::abs(turn), std::abs(common));
  const double left_over = turn / (1.0 + widening(common) * felt);
  return {common - left_over, common + left_over};
}

RimSpeeds DriveLaw::commandFor(RimSpeeds wanted) const {
  if (widening_ == 0.0 && rise_ == 0.0) return wanted;
  const double common = (wanted.left + wanted.right) / 2, turn = (wanted.right - wanted.left) / 2;
  // command over result where |turn| > |common|
  const double most = 1.0 + widening(common) * std::abs(common);
  const bool curve = std::abs(turn) * most <= std::abs(common);
  const double needed = curve ? turn / (1.0 - widening(common) * std::abs(turn)) : turn * most;
  return {common - needed, common + needed};
}

}  // namespace fulbito
