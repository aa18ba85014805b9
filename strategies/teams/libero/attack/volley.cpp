#include "strategies/teams/libero/attack/volley.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/attack/press.hpp"

namespace fulbito::libero {
namespace {

/// The way of a ball after a hit: it slides at first, and then rolls. The first stretches of a
/// `BallPrediction` without the slow braking of a rolling ball. Many runs a tick need one, and a whole
/// prediction takes longer.
struct Flight {
  Vec2 from;  // [m]
  Hit hit;
  double slide;  // [s] until it rolls

  Flight(const Pitch& pitch, Vec2 ball, const Hit& by)
      : from(ball), hit(by), slide(distance(by.leaves, by.rolls) / pitch.slide_deceleration) {}

  Vec2 at(double time) const {
    const double sliding = std::min(time, slide);
    const double bent = slide > 0.0 ? sliding * sliding / (2 * slide) : 0.0;
    return from + hit.leaves * sliding + (hit.rolls - hit.leaves) * bent + hit.rolls * (time - sliding);
  }

  /// Time [s] at which it crosses the line at `x` [m]; empty if it does not.
  std::optional<double> crosses(double x) const {
    const double way = x - from.x;
    const double slid = (hit.leaves.x + hit.rolls.x) / 2 * slide;
    if (slid >= way && slide > 0.0) {
      const double bend = (hit.rolls.x - hit.leaves.x) / slide;
      const double root = std::sqrt(std::max(0.0, hit.leaves.x * hit.leaves.x + 2 * bend * way));
      return 2 * way / (hit.leaves.x + root);
    }
    if (hit.rolls.x <= 0.0) return std::nullopt;
    return slide + (way - slid) / hit.rolls.x;
  }
};

/// The least gap [m] between the ball on its flight, which begins after `wait` [s] and takes `time` [s], and
/// opponents that drive at it from the first moment. Of gaps up to `needed` it only tells that they are.
double gapToOpponents(const Picture& picture, const Flight& flight, double wait, double time, double needed) {
  const Pitch& pitch = picture.pitch;
  double least = pitch.around;  // wider gaps are not better
  for (double t = 0.0; least > needed && t < time + BallForecast::kStep; t += BallForecast::kStep) {
    const double flown = std::min(t, time);
    const Vec2 ball = flight.at(flown);
    const double reach = wayFromRest(pitch.pace, std::max(0.0, flown - 2 * pitch.tick)) + pitch.front;
    const double drift = std::min(wait + flown, pitch.turn_time);
    for (int i = 0; i < picture.seen.team_size; ++i) {
      if (!picture.opponentPresent(i)) continue;
      const RobotState& other = picture.opponent(i);
      least = std::min(least, distance(other.pose.position + other.velocity * drift, ball) - reach);
    }
  }
  return least;
}

/// What a wait of `spare` [s] costs [m]: the way that opponents drive in it.
double priceOf(const Picture& picture, double spare) {
  return wayFromRest(picture.pitch.pace, std::max(0.0, spare));
}

/// How far [m] beside the mouth the ball may go. One that would touch the post from outside still goes in if
/// the run mends its aim on the way.
double mostBeside(const Picture& picture) {
  return picture.disputesFreeBall() ? 2 * picture.pitch.ball_radius : 0.0;
}

/// The run of `self` that meets the ball at `time` [s] from now, if its room less the price of its wait may
/// be more than `most` [m].
std::optional<Volley> runAt(const Picture& picture, const Runner& self, double time, double most) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(time), way = ball - self.position;
  if (way.x <= 0.0) return std::nullopt;
  const double farthest = farthestIn(pitch.pace, self.speed, time + BallForecast::kStep) + pitch.front;
  if (squaredNorm(way) > farthest * farthest) return std::nullopt;
  const double length = norm(way), run = length - pitch.front;
  if (run < 0.0) return std::nullopt;
  const Vec2 ahead = way / length;
  const Vec2 rolling = (picture.ball.at(time + BallForecast::kStep) - ball) / BallForecast::kStep;
  if (dot(rolling, ahead) > 0.0) return std::nullopt;
  const double spare = time - timeToReach(pitch.pace, self, ball - ahead * pitch.front);
  if (spare < -BallForecast::kStep) return std::nullopt;
  const double needed = most + priceOf(picture, spare), widest = pitch.goal_half - pitch.ball_radius;
  if (widest <= needed) return std::nullopt;
  const double start = std::max(0.0, dot(self.velocity, ahead));
  const double speed = std::min(pitch.speed, std::sqrt(start * start + 2 * pitch.acceleration * run));
  const Flight flight(pitch, ball, hitOf(pitch, rolling, ahead, speed));
  const auto flown = flight.crosses(pitch.half_length);
  if (!flown || *flown > BallForecast::kSteps * BallForecast::kStep) return std::nullopt;
  const Vec2 target = flight.at(*flown);
  const double beside = widest - std::abs(target.y);
  if (beside <= std::max(-mostBeside(picture), needed)) return std::nullopt;
  const double room = std::min(beside, gapToOpponents(picture, flight, time, *flown, needed));
  return Volley{time, ball, math::angleOf(way), spare, room, target};
}

}  // namespace

Hit hitOf(const Pitch& pitch, Vec2 rolling, Vec2 ahead, double speed) {
  const Vec2 local = intoFrame(ahead, rolling);
  const double pushed = std::max(0.0, pitch.bounce * (speed - local.x));
  const double rubbed = std::min(std::abs(local.y), pitch.rub * pushed);
  const Vec2 change = outOfFrame(ahead, {pushed, -std::copysign(rubbed, local.y)});
  return {rolling + change, rolling + change * pitch.roll_keep};
}

double leastRoom(const Picture& picture) {
  if (!picture.hasOpponent(false)) return 0.0;
  return picture.disputesFreeBall() ? std::numeric_limits<double>::lowest() : -picture.pitch.front;
}

std::optional<Volley> volleyAt(const Picture& picture, int robot, double time) {
  return runAt(picture, Runner(picture.own(robot)), time, std::numeric_limits<double>::lowest());
}

std::optional<Volley> bestVolley(const Picture& picture, int robot) {
  const Runner self(picture.own(robot));
  std::optional<Volley> best;
  double most = leastRoom(picture);
  for (int i = 0; i < BallForecast::kSteps; ++i) {
    const auto volley = runAt(picture, self, i * BallForecast::kStep, most);
    if (!volley) continue;
    const double room = volley->room - priceOf(picture, volley->spare);
    if (room > most) most = room, best = volley;
  }
  return best;
}

}  // namespace fulbito::libero
