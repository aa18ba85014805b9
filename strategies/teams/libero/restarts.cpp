#include "strategies/teams/libero/restarts.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kBehind = 0.085;  // [m] from the ball's centre to the taker's centre behind it

Pose2 facing(Vec2 from, Vec2 to) { return {from, math::wrapAngle(math::angleOf(to - from))}; }

/// The keeper in the middle of its line and parallel to it.
Pose2 keeperPose(const Pitch& pitch) { return {{-pitch.half_length + 0.042, 0.0}, math::kPi / 2}; }

/// `p` moved so that the whole body is in the own half.
Vec2 ownHalf(const Pitch& pitch, Vec2 p) { return {std::min(p.x, -pitch.robot_corner - 0.001), p.y}; }

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
  const double far = 0.05 + pitch.robot_corner;
  if (request.ours) {
    // The ball goes past opponents that run straight at it, off the middle, toward the support's side.
    const double angle = 0.6;
    placed[1] = facing(-kBehind * math::unit(-hand * angle), {});
    placed[2] = facing({-far, -0.30 * hand}, {0.4, -0.3 * hand});
  } else if (pitch.isLarge()) {
    // The robot meets the ball from the side, so that a ball pushed straight on leaves its face toward the
    // support.
    const double angle = 0.5;
    placed[1] = facing(-(pitch.field.centre_circle_radius + 0.045) * math::unit(-hand * angle), {});
    placed[2] = facing({-pitch.field.centre_circle_radius - 0.02, -0.26 * hand}, {});
  } else {
    // The robot stands beside the line of the kick, which the taker's place shows. There the ball leaves its
    // face toward the support. It meets a straight kick from farther aside.
    const Vec2 taker = takerOf(request).value_or(Vec2{pitch.field.centre_circle_radius, 0.0});
    const double line = math::angleOf(taker);
    const bool straight = std::abs(line) < 0.2;
    const double turn = std::abs(line) > 0.02 ? std::copysign(1.0, line) : hand;
    const Vec2 meeter = math::unit(line - turn * (straight ? 1.05 : 0.5));
    const Vec2 support = math::unit(line + turn * 0.87);
    placed[1] =
        facing(ownHalf(pitch, -(pitch.field.centre_circle_radius + (straight ? 0.04 : 0.001)) * meeter), {});
    placed[2] =
        facing(ownHalf(pitch, -(pitch.field.centre_circle_radius + (straight ? 0.25 : 0.14)) * support), {});
  }
}

void goalKick(const Pitch& pitch, bool ours, Vec2 ball, TeamPlacement& placed) {
  const double side = std::copysign(1.0, ball.y);
  if (ours) {
    const double aside = std::min(std::abs(ball.y) - 0.03, pitch.area_half - pitch.robot_corner - 0.003);
    placed[0] = facing({ball.x - kBehind, side * aside}, ball);
    placed[1] = facing({ball.x + 0.25, std::copysign(pitch.half_width - 0.12, side)},
                       {0.0, std::copysign(pitch.half_width, side)});
    placed[2] = facing({-pitch.half_length + 0.30, 0.0}, ball);
  } else {
    // The robots stand in the own half, as near to the ball as allowed. Robot 1 is in the way of a straight
    // kick, slightly inside, so that the ball goes out to the side wall. In five-a-side matches it stands
    // where the ball comes out along the side wall. Robot 2 is in front of the own goal.
    const double line = -pitch.robot_corner - 0.001;
    const double way = pitch.isLarge() ? side * (pitch.half_width - 0.20) : ball.y - side * 0.05;
    placed[1] = facing({line, way}, ball);
    placed[2] = facing({line - 0.15, side * 0.10}, ball);
  }
}

void penalty(const Pitch& pitch, bool ours, Vec2 ball, TeamPlacement& placed) {
  if (ours) {
    // The run-up brings the taker to full speed before it meets a keeper that runs out. Its slight angle to
    // the support's side lets the ball slip past the keeper there. The places of the rules are mirrored
    // between the sides, not rotated, and this one follows them.
    const double hand = placed[2] && placed[2]->position.y < 0.0 ? -1.0 : 1.0;
    const bool large = pitch.isLarge();
    const double run_up = large ? 0.33 : 0.30, angle = large ? 0.03 : 0.10;
    placed[1] = facing(ball - run_up * math::unit(hand * angle), ball);
    placed[2] = facing({-0.06, hand * 0.35}, ball);
  } else {
    const double hand = placed[1] && placed[1]->position.y < 0.0 ? -1.0 : 1.0;
    placed[0] = Pose2{{-pitch.half_length + pitch.robot_half, hand * 0.06}, 0.0};
    // Wide, out of the way of opponents that run at the ball: they would push the robots into the area.
    constexpr double kWide[] = {-0.55, 0.55, -0.27, 0.27};
    for (std::size_t i = 1; i < std::min<std::size_t>(5, static_cast<std::size_t>(pitch.team_size)); ++i) {
      placed[i] = facing({0.06, hand * kWide[i - 1]}, ball);
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
