#include "match/seats/vision.hpp"

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// Gains of the g-h filter, critically damped: h = 2 (2 - g) - 4 sqrt(1 - g) (Brookner, Tracking and Kalman
// Filtering Made Easy, 1998, table 1.5.1, with theta^2 = 1 - g). The rate's noise is 0.2 sigma / dt. The
// filter follows a constant rate without error, and a jump of the rate within about six ticks.
constexpr double kPositionGain = 0.5;
constexpr double kRateGain = 0.1715728752538099;

}  // namespace

Vision::Vision(const VisionModel& model, std::uint64_t seed, TeamId seat, double dt)
    : dt_(dt), sensor_(model, Rng(seed, Stream::kVision, indexOf(seat))), pictures_(model.latency_ticks) {}

void Vision::reset(const WorldState& world) {
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const RobotState& robot = world.robots[i];
    last_.robots[i] = robot;
    tracks_[i] = {{robot.pose.position.x, robot.velocity.x},
                  {robot.pose.position.y, robot.velocity.y},
                  {robot.pose.heading, robot.angular_velocity},
                  0};
  }
  const BallState& ball = world.balls.front();
  last_.ball = ball;
  tracks_.back() = {{ball.position.x, ball.velocity.x}, {ball.position.y, ball.velocity.y}, {}, 0};
  pictures_.fill(last_);
}

bool Vision::seen(BodyTracks& tracks) {
  ++tracks.gap;
  return sensor_.sees();
}

// One prediction and correction of the filter over the ticks since the body was last seen. A gap in the
// pictures divides the correction of the rate.
void Vision::blur(BodyTracks& tracks, Vec2& position, Vec2& velocity) {
  if (!sensor_.blur(position)) return;
  const double elapsed = dt_ * tracks.gap;
  const auto follow = [&](Track& track, double value, double& rate) {
    const double predicted = track.value + track.rate * elapsed;
    const double surprise = value - predicted;
    track = {predicted + kPositionGain * surprise, track.rate + kRateGain / elapsed * surprise};
    rate = track.rate;
  };
  follow(tracks.x, position.x, velocity.x);
  follow(tracks.y, position.y, velocity.y);
}

void Vision::blur(BodyTracks& tracks, double& heading, double& rate) {
  if (!sensor_.blurHeading(heading)) return;
  const double elapsed = dt_ * tracks.gap;
  Track& track = tracks.heading;
  const double predicted = track.value + track.rate * elapsed;
  const double surprise = math::wrapAngle(heading - predicted);
  track = {math::wrapAngle(predicted + kPositionGain * surprise),
           track.rate + kRateGain / elapsed * surprise};
  rate = track.rate;
}

void Vision::look(const WorldState& world) {
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    BodyTracks& tracks = tracks_[i];
    if (!seen(tracks)) continue;
    RobotState& robot = last_.robots[i] = world.robots[i];
    blur(tracks, robot.pose.position, robot.velocity);
    blur(tracks, robot.pose.heading, robot.angular_velocity);
    tracks.gap = 0;
  }
  BodyTracks& tracks = tracks_.back();
  if (!seen(tracks)) return;
  last_.ball = world.balls.front();
  blur(tracks, last_.ball.position, last_.ball.velocity);
  tracks.gap = 0;
}

const Sight& Vision::see(const WorldState& world) {
  look(world);
  pictures_.take(last_);
  return pictures_.shown();
}

}  // namespace fulbito
