#include "strategies/prediction/wheel_track.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kSlides = 0.03;   // [m/s] motion that the wheels do not show, such as slip in curves
constexpr double kTurns = 0.6;     // [rad/s] the same of the yaw rate
constexpr double kSurprise = 4.0;  // standard deviations: something has pushed the robot

/// The steady gain of a filter for a value that drifts by `drift` per step and is seen with `noise`.
double gainFor(double drift, double noise) {
  if (!(noise > 0.0)) return 1.0;
  const double ratio = drift / noise, square = ratio * ratio;
  return (std::sqrt(square * square + 4.0 * square) - square) / 2.0;
}

}  // namespace

RobotState WheelTrack::update(const RobotState& seen, double dt) {
  if (!known_) {
    known_ = true;
    last_ = seen;
    seen_ = seen.pose;
    return seen;
  }
  const Twist before = forwardKinematics(robot_, last_.wheels), now = forwardKinematics(robot_, seen.wheels);
  const double turned = (before.angular + now.angular) / 2 * dt;
  const Vec2 middle = math::unit(last_.pose.heading + turned / 2);
  const Vec2 aside = perp(middle) * dot(seen.velocity, perp(middle));
  RobotState state = seen;
  state.pose.position = last_.pose.position + (middle * ((before.linear + now.linear) / 2) + aside) * dt;
  state.pose.heading = math::wrapAngle(last_.pose.heading + turned);
  if (!(seen.pose.position == seen_.position)) {
    const Vec2 off = seen.pose.position - state.pose.position;
    const double most = kSurprise * position_noise_;
    const double gain = squaredNorm(off) > most * most ? 1.0 : gainFor(kSlides * dt, position_noise_);
    state.pose.position += off * gain;
    const double turn = math::wrapAngle(seen.pose.heading - state.pose.heading);
    const double share =
        std::abs(turn) > kSurprise * heading_noise_ ? 1.0 : gainFor(kTurns * dt, heading_noise_);
    state.pose.heading = math::wrapAngle(state.pose.heading + turn * share);
    seen_ = seen.pose;
  }
  state.velocity = math::unit(state.pose.heading) * now.linear + aside;
  state.angular_velocity = now.angular;
  last_ = state;
  return state;
}

}  // namespace fulbito
