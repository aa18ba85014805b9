#include "strategies/teams/libero/drawing.hpp"

#include <cmath>

#include <fmt/format.h>

#include "strategies/interface/drawings.hpp"

namespace fulbito::libero {
namespace {

/// Draws the predicted course of the ball, one line for each straight stretch.
void drawBall(const Picture& picture, std::vector<DebugDrawing>& drawings) {
  constexpr double kStraight = 2e-3;  // [m] resolution of drawings
  const BallForecast& ball = picture.ball;
  if (ball.resting()) return;
  Vec2 from = ball.sample(0), to = ball.sample(1);
  for (int i = 2; i <= BallForecast::kSteps; ++i) {
    const Vec2 next = ball.sample(i), way = unitOr(next - from, {1.0, 0.0});
    if (std::abs(cross(way, to - from)) > kStraight) {
      addLine(drawings, from, to);
      from = to;
    }
    to = next;
  }
  addLine(drawings, from, to);
  addCircle(drawings, to, picture.pitch.ball_radius);
}

const char* nameOf(Role role) {
  switch (role) {
    case Role::kKeeper:
      return "keeper";
    case Role::kStriker:
      return "striker";
    case Role::kSupport:
      break;
  }
  return "support";
}

void drawMove(const Pitch& pitch, Vec2 robot, Role role, const Move& move,
              std::vector<DebugDrawing>& drawings) {
  Vec2 from = robot;
  if (move.place) {
    addCircle(drawings, *move.place, pitch.ball_radius);
    // The keeper is nearly always at its place: a line there says nothing.
    if (role != Role::kKeeper) addLine(drawings, from, *move.place);
    from = *move.place;
  }
  if (move.ball) {
    addLine(drawings, from, *move.ball);
    from = *move.ball;
  }
  if (move.target) {
    addLine(drawings, from, *move.target);
    addCircle(drawings, *move.target, pitch.ball_radius);
  }
  addName(drawings, robot, fmt::format("{}: {}", nameOf(role), move.skill).c_str());
  addRemark(drawings, robot, move.reason);
}

}  // namespace

void draw(const Picture& picture, const Roles& roles, std::span<const Move> moves,
          std::vector<DebugDrawing>& drawings) {
  drawBall(picture, drawings);
  for (int i = 0; i < picture.seen.team_size; ++i) {
    const auto robot = static_cast<std::size_t>(i);
    if (picture.ownPresent(i))
      drawMove(picture.pitch, picture.own(i).pose.position, roles.of(i), moves[robot], drawings);
  }
}

}  // namespace fulbito::libero
