#include "strategies/teams/libero/drawing.hpp"

#include <cmath>

#include "strategies/interface/drawings.hpp"
#include "strategies/teams/libero/attack/meet.hpp"
#include "strategies/teams/libero/attack/support.hpp"
#include "strategies/teams/libero/defence/keeper.hpp"

namespace fulbito::libero {
namespace {

constexpr double kPlace = 0.015;  // [m] radius of the mark of a place to be at

/// The forecast's way, a line for each stretch that is straight.
void drawBall(const Picture& picture, std::vector<DebugDrawing>& drawings) {
  constexpr double kStraight = 2e-3;  // [m]
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

/// Where the ball is met, from where it is pushed, and which part of their goal is meant.
void drawStriker(const Picture& picture, int robot, const StrikerMemory& memory,
                 std::vector<DebugDrawing>& drawings) {
  constexpr double kBehind = 0.065;  // [m] from the ball's middle to the striker's
  const Interception meet = interception(picture, picture.own(robot));
  const Vec2 mouth{picture.pitch.half_length, memory.mouth};
  const Aim aim = aimAt(picture.pitch, meet.ball, mouth);
  const Vec2 behind = picture.pitch.inside(aim.contact - aim.direction * kBehind, picture.pitch.robot_half);
  addLine(drawings, picture.own(robot).pose.position, behind);
  addCircle(drawings, behind, kPlace);
  addLine(drawings, behind, meet.ball);
  if (aim.wall) {
    addLine(drawings, meet.ball, picture.pitch.inside(meet.ball + aim.direction * 0.15, 0.0));
  } else {
    addLine(drawings, meet.ball, mouth);
    addCircle(drawings, mouth, kPlace);
  }
}

}  // namespace

void draw(const Picture& picture, const Roles& roles, const StrikerMemory& memory,
          std::vector<DebugDrawing>& drawings) {
  drawBall(picture, drawings);
  int rank = 0;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (!picture.ownPresent(i)) continue;
    const Vec2 self = picture.own(i).pose.position;
    const char* name = "support";
    if (i == roles.keeper) {
      name = "keeper";
      addCircle(drawings, keeperGoal(picture), kPlace);
    } else if (i == roles.striker && !roles.keepers_ball) {
      name = "striker";
      drawStriker(picture, i, memory, drawings);
    } else {
      const Vec2 place = roles.keepers_ball ? waitingPlace(picture, rank) : supportPlace(picture, i, rank);
      ++rank;
      if (!canMeetBrought(picture, picture.own(i))) {
        addLine(drawings, self, place);
        addCircle(drawings, place, kPlace);
      }
    }
    addName(drawings, self, name);
  }
}

}  // namespace fulbito::libero
