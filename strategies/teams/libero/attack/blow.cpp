#include "strategies/teams/libero/attack/blow.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

/// The direction of the strike that makes a ball with the velocity `moving` run along `wanted`. It cancels
/// the velocity across `wanted`; a ball that rests would leave at `leaves` [m/s].
Vec2 blow(double leaves, Vec2 wanted, Vec2 moving) {
  const Vec2 local = intoFrame(wanted, moving);
  return unitOr(outOfFrame(wanted, {std::max(leaves / 2, leaves - local.x), -local.y}), wanted);
}

/// How much bodies obstruct a strike at `contact` along `direction`: 1 for each body in the striker's place,
/// and 1 for each right in front of the ball.
double barred(const Picture& picture, int robot, Vec2 contact, Vec2 direction) {
  const Pitch& pitch = picture.pitch;
  const Vec2 behind = contact - direction * pitch.front, ahead = contact + direction * pitch.touch;
  const double place = 2 * pitch.robot_half, way = pitch.front;
  double cost = 0.0;
  const auto look = [&](Vec2 body, double weight) {
    const double near = squaredNorm(body - behind), far = squaredNorm(body - ahead);
    if (near < place * place) cost += weight;
    if (far < way * way) cost += weight;
  };
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i)) look(picture.opponent(i).pose.position, 1.0);
    if (i != robot && picture.ownPresent(i)) look(picture.own(i).pose.position, 1.0);
  }
  return cost;
}

}  // namespace

Vec2 blowInTime(const Pitch& pitch, Vec2 robot, const Aim& aim, Vec2 moving) {
  const Tuning& tuning = pitch.tuning;
  const Vec2 best = blow(tuning.strike_speed, aim.direction, moving);
  const Vec2 way = aim.contact - robot;
  const double length = norm(way), speed = norm(moving);
  // A slow ball is still there after the way round it.
  if (speed < tuning.rolls || length < pitch.robot_half) return best;
  double most = tuning.turn_in;
  // A robot that speeds up fast overtakes a ball that runs ahead of it, and has time for a turn on its way to
  // the ball. Others turn next to the ball, too, since one whose course they do not mend is lost for longer.
  if (pitch.shoves) {
    if (dot(moving, way) > math::cos(tuning.turn_in) * speed * length) return best;
    most *= std::min(1.0, (length - pitch.robot_half) / (pitch.bodies + pitch.front));
  }
  const double bearing = math::angleOf(way);
  const double turn = math::wrapAngle(math::angleOf(best) - bearing);
  if (std::abs(turn) < most) return best;
  const Vec2 early = math::unit(bearing + std::copysign(most, turn));
  return early.x > 0.5 ? early : best;
}

Vec2 clearStrikeDirection(const Picture& picture, int robot, const Aim& aim, int& previous) {
  constexpr int kTurns[] = {0, 1, -1, 2, -2, 3, -3};
  const Tuning& tuning = picture.tuning;
  const Pitch& pitch = picture.pitch;
  // Unit vectors of the turns to the left; those to the right mirror them.
  const Vec2 once = math::unit(tuning.turn_in), twice = outOfFrame(once, once);
  const Vec2 units[] = {once, twice, outOfFrame(twice, once)};
  const Vec2 self = picture.own(robot).pose.position;
  double least = 1e9;
  int best = 0;
  Vec2 chosen = aim.direction;
  for (int i = 0; i < 7; ++i) {
    Vec2 direction = aim.direction;
    if (i > 0) {
      const Vec2 turn = units[(i - 1) / 2];
      direction = outOfFrame(direction, kTurns[i] > 0 ? turn : Vec2{turn.x, -turn.y});
    }
    const Vec2 spot = aim.contact - direction * pitch.front;
    const double turn = tuning.turn_price * tuning.turn_in * std::abs(kTurns[i]), way = distance(self, spot);
    const double bonus = i == previous ? tuning.keep_price : 0.0;
    const bool walled = distance(insideWalls(pitch.field, spot, pitch.robot_half), spot) > tuning.clearance;
    const double wall = walled ? 2.0 : 0.0;
    // Bodies only add to the cost, so most directions need no look at them.
    if (turn + way + wall - bonus > least + 1e-9) continue;
    const double cost = turn + barred(picture, robot, aim.contact, direction) + way + wall - bonus;
    if (cost < least) least = cost, best = i, chosen = direction;
  }
  previous = best;
  return chosen;
}

}  // namespace fulbito::libero
