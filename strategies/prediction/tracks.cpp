#include "strategies/prediction/tracks.hpp"

#include <algorithm>

namespace fulbito {

Tracks::Tracks(const MatchInfo& info) : needed_(info.position_noise > 0.0) {
  own_.fill(WheelTrack(info.robot, info.position_noise, info.heading_noise));
  opponents_.fill(PointTrack(info.position_noise));
  ball_ = PointTrack(info.position_noise);
}

void Tracks::reset() {
  for (WheelTrack& robot : own_) robot.reset();
  for (PointTrack& robot : opponents_) robot.reset();
  ball_.reset();
}

void Tracks::follow(Observation& seen) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    if (seen.own[i].present) seen.own[i].state = own_[i].update(seen.own[i].state, seen.dt);
    if (!seen.opponents[i].present) continue;
    RobotState& opponent = seen.opponents[i].state;
    opponents_[i].update(opponent.pose.position, opponent.velocity, {}, seen.dt);
    opponent.pose.position = opponents_[i].position();
    opponent.velocity = opponents_[i].velocity();
  }
}

BallState Tracks::follow(BallState ball, double drag, double dt) {
  const Vec2 change = unitOr(ball_.velocity(), {}) * -std::min(drag, norm(ball_.velocity()) / dt);
  ball_.update(ball.position, ball.velocity, change, dt);
  ball.position = ball_.position();
  ball.velocity = ball_.velocity();
  return ball;
}

}  // namespace fulbito
