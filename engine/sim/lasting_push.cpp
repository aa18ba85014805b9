#include "engine/sim/lasting_push.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

/// A wall pushes back whatever tyres do, which looks like a push that they hold. The part left out lets such
/// a force fade within a few steps, which would else press the robot to the wall for ever.
constexpr double kHeld = 0.9;

/// What has lasted of two changes.
double lasting(double one, double two) {
  if (one * two <= 0.0) return 0.0;
  return std::copysign(kHeld * std::min(std::abs(one), std::abs(two)), one);
}

}  // namespace

void LastingPush::measure(const BodyMotion& before, const BodyMotion& after) {
  const BodyMotion now{after.forward - before.forward, after.sideways - before.sideways,
                       after.yaw - before.yaw};
  expected_ = {lasting(now.forward, last_.forward), lasting(now.sideways, last_.sideways),
               lasting(now.yaw, last_.yaw)};
  last_ = now;
}

}  // namespace fulbito
