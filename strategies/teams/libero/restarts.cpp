#include "strategies/teams/libero/restarts.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"

namespace fulbito::libero {
namespace {

/// [m] from the ball's centre to the taker's centre behind it.
double runUp(const Pitch& pitch) { return pitch.touch + pitch.tuning.clearance; }

Pose2 facing(Vec2 from, Vec2 to) { return {from, math::wrapAngle(math::angleOf(to - from))}; }

/// The keeper in the middle of its line and parallel to it.
Pose2 keeperPose(const Pitch& pitch) { return {{keeperLine(pitch), 0.0}, math::kPi / 2}; }

/// The greatest x [m] at which the whole body is in the own half.
double ownLine(const Pitch& pitch) { return -pitch.robot_corner - pitch.tuning.clearance; }

/// The position of the opponent that takes the restart: the one nearest to the ball.
std::optional<Vec2> takerOf(const PlacementRequest& request) {
  std::optional<Vec2> taker;
  if (!request.opponents) return taker;
  for (const std::optional<Pose2>& pose : *request.opponents) {
    if (!pose) continue;
    if (!taker || distance(pose->position, request.ball) < distance(*taker, request.ball))
      taker = pose->position;
  }
  return taker;
}

void kickOff(const Pitch& pitch, const PlacementRequest& request, double hand, TeamPlacement& placed) {
  // In five-a-side matches the rules place robots on one side. Robots that stay at those places decide the
  // side.
  if (placed[2] && placed[2]->position.y != 0.0) hand = std::copysign(1.0, placed[2]->position.y);
  const double circle = pitch.field.centre_circle_radius, wide = pitch.half_width / 2;
  // A crowd holds a ball that comes straight. There it goes past, toward the support's side.
  const double turn = pitch.isLarge() ? -hand * pitch.tuning.kick_off_turn : 0.0;
  if (request.ours) {
    placed[1] = facing(-runUp(pitch) * math::unit(turn), {});
    placed[2] = facing({ownLine(pitch) - pitch.front, -wide * hand}, {circle, -wide * hand});
  } else if (pitch.isLarge()) {
    // A ball pushed straight on leaves the robot's face toward the support.
    placed[1] = facing(-(circle + pitch.robot_corner) * math::unit(turn), {});
    placed[2] = facing({-circle - pitch.ball_radius, -(circle + pitch.front) * hand}, {});
  } else {
    // One robot is in the way of a straight kick. The other one waits beside the circle where a slanting kick
    // goes, which the taker's place shows.
    const double taker = takerOf(request).value_or(Vec2{}).y;
    const double side = std::abs(taker) > pitch.tuning.clearance ? std::copysign(1.0, taker) : hand;
    placed[1] = facing({-circle - pitch.tuning.clearance, 0.0}, {});
    placed[2] = facing({ownLine(pitch), -side * (circle + pitch.around)}, {});
  }
}

void goalKick(const Pitch& pitch, bool ours, Vec2 ball, TeamPlacement& placed) {
  const double side = std::copysign(1.0, ball.y), gap = pitch.tuning.clearance;
  if (ours) {
    // The keeper runs up from the end wall. Its kick comes to the side wall in their half and follows it,
    // past opponents that run at the ball.
    const Vec2 aim{pitch.half_length / 2, side * (pitch.half_width - pitch.ball_radius)};
    const Vec2 way = unitOr(aim - ball, {1.0, 0.0});
    const double room = (ball.x + pitch.half_length - pitch.robot_corner - gap) / way.x;
    placed[0] = facing(ball - std::max(room, runUp(pitch)) * way, ball);
    placed[1] = facing({ball.x + 2 * pitch.around, std::copysign(pitch.half_width - pitch.around, side)},
                       {0.0, std::copysign(pitch.half_width, side)});
    placed[2] = facing({-pitch.half_length + pitch.area_front + pitch.bodies, 0.0}, ball);
  } else {
    // The robots stand in the own half, as near to the ball as allowed. Robot 1 is in the way of a straight
    // kick, slightly inside, so that the ball goes out to the side wall. In five-a-side matches it stands
    // where the ball comes out along the side wall. Robot 2 is in front of the own goal.
    const double line = ownLine(pitch);
    const double way =
        pitch.isLarge() ? side * (pitch.half_width - 2 * pitch.bodies) : ball.y - side * pitch.robot_corner;
    placed[1] = facing({line, way}, ball);
    placed[2] = facing({line - pitch.around, side * pitch.bodies}, ball);
  }
}

void penalty(const Pitch& pitch, bool ours, Vec2 ball, TeamPlacement& placed) {
  if (ours) {
    // The taker stands on the line from the inside of the post on the support's side. It runs straight at the
    // ball, so fast that a keeper in the middle comes late. The places of the rules are mirrored between the
    // sides, not rotated, and this one follows them.
    const double hand = placed[2] && placed[2]->position.y < 0.0 ? -1.0 : 1.0;
    const Vec2 corner{pitch.half_length, hand * (pitch.goal_half - 2 * pitch.ball_radius)};
    const Vec2 from = ball - pitch.tuning.run_up * unitOr(corner - ball, {1.0, 0.0});
    placed[1] = facing(insideWalls(pitch.field, from, pitch.robot_corner), ball);
    placed[2] = facing({ownLine(pitch), hand * pitch.half_width / 2}, ball);
  } else {
    // Wide, out of the way of opponents that run at the ball: they would push the robots into the area.
    const double hand = placed[1] && placed[1]->position.y < 0.0 ? -1.0 : 1.0;
    const double wide = pitch.half_width - pitch.bodies;
    const double places[] = {-wide, wide, -wide / 2, wide / 2};
    for (std::size_t i = 1; i < std::min<std::size_t>(5, static_cast<std::size_t>(pitch.team_size)); ++i) {
      placed[i] = facing({-ownLine(pitch), hand * places[i - 1]}, ball);
    }
  }
}

}  // namespace

TeamPlacement placementAt(const Pitch& pitch, const PlacementRequest& request, double hand) {
  TeamPlacement placed = request.defaults;
  if (pitch.team_size < 3 || request.kind == RestartKind::kGiven) return placed;
  // At a free ball all but the nearest robots stay where they are. At a free kick the default places are
  // good.
  if (request.kind == RestartKind::kFreeBall || request.kind == RestartKind::kFreeKick) return placed;
  placed[0] = keeperPose(pitch);
  if (request.kind == RestartKind::kKickOff) kickOff(pitch, request, hand, placed);
  if (request.kind == RestartKind::kGoalKick) goalKick(pitch, request.ours, request.ball, placed);
  if (request.kind == RestartKind::kPenalty) penalty(pitch, request.ours, request.ball, placed);
  return placed;
}

}  // namespace fulbito::libero
