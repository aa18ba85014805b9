#include "strategies/teams/libero/attack/press.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/defence/dribble.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {

bool disputesFreeBall(const Observation& seen) {
  return seen.restart == RestartKind::kFreeBall && seen.since_restart < kDispute;
}

Vec2 firstTouch(const Picture& picture) {
  const Vec2 ball = picture.ball.now().position;
  if (picture.seen.restart != RestartKind::kFreeBall || !picture.pitch.isLarge()) return ball;
  return ball - Vec2{0.0, std::copysign(kInner, ball.y)};
}

void watchJam(const Picture& picture, int robot, PressMemory& memory) {
  constexpr double kBallLies = 0.08, kRobotStands = 0.12;  // [m/s]
  const bool slow = squaredNorm(picture.ball.now().velocity) < kBallLies * kBallLies &&
                    squaredNorm(picture.own(robot).velocity) < kRobotStands * kRobotStands;
  const bool near = squaredNorm(picture.ballFrom(robot)) < kTouch * kTouch;
  memory.jammed = slow && near ? memory.jammed + picture.seen.dt : 0.0;
}

Twist pressOn(const Picture& picture, int robot, PressMemory& memory) {
  constexpr double kPinched = 0.3;    // [s] of pressing, after which the robot lets the ball slip out
  constexpr double kSlip = 0.3;       // [s] time that the robot lets it slip
  constexpr double kSlipTurn = 0.15;  // [rad] turn of the face; at 0.25 the opponent gets the ball
  const RobotState& self = picture.own(robot);
  memory.slipping = memory.jammed > kPinched ? kSlip : memory.slipping - picture.seen.dt;
  if (memory.slipping <= 0.0) return passThrough(self, firstTouch(picture), picture.pitch.speed);
  const double out = std::copysign(kSlipTurn, picture.ball.now().position.y);
  return alongHeading(self, math::angleOf(picture.ballFrom(robot)) + out, picture.pitch.speed);
}

}  // namespace fulbito::libero
