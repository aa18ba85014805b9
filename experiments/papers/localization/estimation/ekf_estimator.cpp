#include "experiments/papers/localization/estimation/ekf_estimator.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

#include "experiments/papers/localization/estimation/wall_ahead.hpp"

namespace fulbito::localization {
namespace {

constexpr int kSize = static_cast<int>(EkfEstimator::kStates);
enum StateIndex { kX, kY, kHeading, kBias, kEchoSpeed, kScale };

using State = Eigen::Matrix<double, kSize, 1>;
using Covariance = Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor>;

Eigen::Map<Covariance> mapped(std::array<double, EkfEstimator::kStates * EkfEstimator::kStates>& values) {
  return Eigen::Map<Covariance>(values.data());
}

double squared(double value) { return value * value; }

// Greatest angle from a wall's perpendicular at which an echo is used, as a share of the cone. It leaves room
// for heading errors.
constexpr double kUsedCone = 0.8;

}  // namespace

EkfEstimator::EkfEstimator(const Knowledge& known, const EkfSettings& settings)
    : known_(known), settings_(settings), state_{known.pose.position.x, known.pose.position.y,
                                                 known.pose.heading,    known.gyro_bias,
                                                 known.echo_speed,      1.0} {
  auto p = mapped(covariance_);
  constexpr std::array kPlaces{kX, kY, kEchoSpeed};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) p(kPlaces[i], kPlaces[j]) = settings.start[i * 3 + j];
  }
  p(kHeading, kHeading) = squared(settings.start_heading);
  p(kBias, kBias) = squared(settings.start_bias);
  p(kScale, kScale) = squared(settings.encoder_scale) / 2;  // mean of two wheels
}

void EkfEstimator::advance(const InnerMotion& motion) {
  const double turned = (motion.turn_rate - state_[kBias]) * motion.dt;
  const double way = motion.distance * state_[kScale];
  const math::SinCos along = math::sinCos(state_[kHeading] + turned / 2);
  Covariance f = Covariance::Identity();
  f(kX, kHeading) = -way * along.sin;
  f(kY, kHeading) = way * along.cos;
  f(kX, kBias) = way * along.sin * motion.dt / 2;
  f(kY, kBias) = -way * along.cos * motion.dt / 2;
  f(kX, kScale) = motion.distance * along.cos;
  f(kY, kScale) = motion.distance * along.sin;
  f(kHeading, kBias) = -motion.dt;
  const Covariance predicted = f * mapped(covariance_) * f.transpose();
  mapped(covariance_) = predicted;
  addTurnErrors(turned, motion.distance, motion.dt);
  const Pose2 moved = movedBy(pose(), way, turned);
  state_[kX] = moved.position.x;
  state_[kY] = moved.position.y;
  state_[kHeading] = moved.heading;
}

void EkfEstimator::addTurnErrors(double turned, double distance, double dt) {
  // A scale error causes correlated errors during a turn. White noise with this variance per radian has the
  // same sum over a quarter turn.
  const double per_turn = math::kPi / 2 * std::abs(turned);
  const double wheel_way = settings_.encoder_scale * known_.axle_track / 2;
  const double along = squared(settings_.slip) / 2 * std::abs(distance) + squared(wheel_way) / 2 * per_turn;
  const math::SinCos heading = math::sinCos(state_[kHeading]);
  auto p = mapped(covariance_);
  p(kX, kX) += along * squared(heading.cos);
  p(kY, kY) += along * squared(heading.sin);
  p(kX, kY) += along * heading.cos * heading.sin;
  p(kY, kX) = p(kX, kY);
  p(kHeading, kHeading) += squared(settings_.gyro_noise * dt) + squared(settings_.gyro_scale) * per_turn;
  p(kBias, kBias) += squared(settings_.gyro_drift) * dt;
}

void EkfEstimator::observe(const EchoTimes& times) {
  for (const Beam beam : kBeams) {
    if (times[indexOf(beam)]) update(beam, *times[indexOf(beam)]);
  }
}

void EkfEstimator::update(Beam beam, double time) {
  const WallAhead wall = wallAhead(known_.room, known_.body, pose(), beam);
  if (std::abs(wall.incidence) > kUsedCone * known_.cone || wall.distance <= 0.0) return;
  const double speed = state_[kEchoSpeed];
  State h = State::Zero();
  h(wall.across_x ? kX : kY) = -wall.sign / speed;
  h(kHeading) = wall.by_heading / speed;
  h(kEchoSpeed) = -wall.distance / (speed * speed);
  auto p = mapped(covariance_);
  const State ph = p * h;
  const double variance = h.dot(ph) + squared(known_.range_sigma / speed);
  const double difference = time - wall.distance / speed;
  if (squared(difference) > squared(settings_.gate) * variance) return;
  const State gain = ph / variance;
  Eigen::Map<State>(state_.data()) += gain * difference;
  state_[kHeading] = math::wrapAngle(state_[kHeading]);
  const Covariance reduced = p - gain * ph.transpose();
  p = (reduced + reduced.transpose()) / 2;
}

double EkfEstimator::squaredError(const Pose2& truth) const {
  const Eigen::Vector3d error(truth.position.x - state_[kX], truth.position.y - state_[kY],
                              math::wrapAngle(truth.heading - state_[kHeading]));
  const Eigen::Matrix3d p = Eigen::Map<const Covariance>(covariance_.data()).topLeftCorner<3, 3>();
  return error.dot(p.inverse() * error);
}

}  // namespace fulbito::localization
