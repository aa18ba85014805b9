#include "strategies/prediction/foresight.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

Estimator::Estimator(const MatchInfo& info) : robot_(info.robot) {
  constexpr double kFading = 0.3;  // [s] time constant with which opponents' motion fades
  const double dt = info.physics.controlPeriod();
  ticks_ = static_cast<int>(std::floor(info.observation_age / dt + 0.5));
  age_ = ticks_ * dt;
  fade_ = kFading * (1.0 - math::exp(-age_ / kFading));
  queue_.assign(static_cast<std::size_t>(ticks_), Sent{});
}

void Estimator::reset() {
  for (Sent& sent : queue_) sent.fill({});
  oldest_ = 0;
}

const Observation& Estimator::update(const Observation& seen, const BallPrediction& ball) {
  // The header says that the result is valid only as long as `seen`.
  if (ticks_ == 0) return seen;  // NOLINT(bugprone-return-const-ref-from-parameter)
  queue_[oldest_] = seen.sent;
  oldest_ = (oldest_ + 1) % queue_.size();
  now_ = seen;
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    if (seen.own[i].present) {
      for (std::size_t k = 0; k < queue_.size(); ++k) {
        const WheelSpeeds command = queue_[(oldest_ + k) % queue_.size()][i];
        now_.own[i].state = rolledForward(robot_, now_.own[i].state, command, seen.dt);
      }
    }
    RobotState& opponent = now_.opponents[i].state;
    opponent.pose.position += opponent.velocity * fade_;
    opponent.pose.heading = math::wrapAngle(opponent.pose.heading + opponent.angular_velocity * fade_);
  }
  now_.ball.position = ball.positionAt(age_);
  now_.ball.velocity = ball.velocityAt(age_);
  return now_;
}

Foresight::Foresight(const MatchInfo& info, double horizon)
    : course_(info.field, info.ball, info.physics),
      pace_(info.robot),
      tracks_(info),
      estimator_(info),
      horizon_(horizon) {}

const Observation& Foresight::update(const Observation& observed) {
  play_began_ = observed.since_restart < last_since_restart_;
  last_since_restart_ = observed.since_restart;
  if (play_began_) {
    tracker_.reset();
    tracks_.reset();
    estimator_.reset();
  }
  if (tracks_.isNeeded()) {
    tracked_ = observed;
    tracks_.follow(tracked_);
    tracked_.ball = tracks_.follow(observed.ball, course_.ball.roll_deceleration, observed.dt);
  }
  const Observation& seen = tracks_.isNeeded() ? tracked_ : observed;
  ball_ = tracker_.update(course_, seen.ball, seen.dt);
  prediction_.predict(course_, ball_, horizon_);
  const Observation& now = estimator_.update(seen, prediction_);
  if (estimator_.isNeeded()) {
    ball_ = prediction_.ballAt(estimator_.age());
    prediction_.predict(course_, ball_, horizon_);
  }
  return now;
}

}  // namespace fulbito
