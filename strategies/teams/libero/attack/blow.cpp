#include "strategies/teams/libero/attack/blow.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kRolling = 0.25;  // [m/s] a slower ball is still there after the robot has driven round it
constexpr double kNear = 0.033;    // [m] at smaller distances there is no room to turn
constexpr double kTurnIn = 0.5;    // [rad] largest turn of the robot before the touch
constexpr double kTurnOn = 3.0;    // [rad/m] the same limit per distance on the last 20 cm
constexpr double kReceding = 0.9;  // cosine: the robot overtakes a ball that runs ahead of it
constexpr double kUpfield = 0.5;   // least cosine between an early strike and upfield

/// The direction of the strike that makes a ball with the velocity `moving` run along `wanted`. It cancels
/// the velocity across `wanted`.
Vec2 blow(Vec2 wanted, Vec2 moving) {
  const Vec2 local = intoFrame(wanted, moving);
  return unitOr(outOfFrame(wanted, {std::max(0.8, 1.3 - local.x), -local.y}), wanted);
}

/// How much bodies obstruct a strike at `contact` along `direction`: 1 for each body in the striker's place,
/// and 1 for each right in front of the ball.
double barred(const Picture& picture, int robot, Vec2 contact, Vec2 direction) {
  const Vec2 behind = contact - direction * 0.065, ahead = contact + direction * 0.07;
  double cost = 0.0;
  const auto look = [&](Vec2 body, double weight) {
    const double near = squaredNorm(body - behind), far = squaredNorm(body - ahead);
    if (near < 0.075 * 0.075) cost += weight;
    if (far < 0.065 * 0.065) cost += weight;
  };
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i)) look(picture.opponent(i).pose.position, 1.0);
    if (i != robot && picture.ownPresent(i)) look(picture.own(i).pose.position, 1.0);
  }
  return cost;
}

}  // namespace

Vec2 blowInTime(Vec2 robot, const Aim& aim, Vec2 moving) {
  const Vec2 best = blow(aim.direction, moving);
  const Vec2 way = aim.contact - robot;
  const double length = norm(way), speed = norm(moving);
  if (speed < kRolling || length < kNear || dot(moving, way) > kReceding * speed * length) return best;
  const double bearing = math::angleOf(way);
  const double turn = math::wrapAngle(math::angleOf(best) - bearing);
  const double most = std::clamp(kTurnOn * (length - kNear), 0.0, kTurnIn);
  if (std::abs(turn) < most) return best;
  const Vec2 early = math::unit(bearing + std::copysign(most, turn));
  return early.x > kUpfield ? early : best;
}

Vec2 clearStrikeDirection(const Picture& picture, int robot, const Aim& aim, int& previous) {
  constexpr double kTurns[] = {0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5};
  // Unit vectors of the turns to the left; those to the right mirror them.
  static const Vec2 kUnits[] = {math::unit(0.5), math::unit(1.0), math::unit(1.5)};
  const Vec2 self = picture.own(robot).pose.position;
  double least = 1e9;
  int best = 0;
  Vec2 chosen = aim.direction;
  for (int i = 0; i < 7; ++i) {
    Vec2 direction = aim.direction;
    if (i > 0) {
      const Vec2 turn = kUnits[(i - 1) / 2];
      direction = outOfFrame(direction, kTurns[i] > 0.0 ? turn : Vec2{turn.x, -turn.y});
    }
    const Vec2 spot = aim.contact - direction * 0.065;
    const double turn = 0.3 * std::abs(kTurns[i]), way = distance(self, spot);
    const double bonus = i == previous ? 0.15 : 0.0;
    // Bodies and walls only add to the cost, so most directions need no look at them.
    constexpr double kRounding = 1e-9;
    if (turn + way - bonus > least + kRounding) continue;
    double cost = turn + barred(picture, robot, aim.contact, direction) + way;
    if (squaredNorm(insideWalls(picture.pitch.field, spot, 0.037) - spot) > 1e-4) cost += 2.0;
    cost -= bonus;
    if (cost < least) least = cost, best = i, chosen = direction;
  }
  previous = best;
  return chosen;
}

}  // namespace fulbito::libero
