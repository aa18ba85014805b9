#include "strategies/teams/libero/attack/shot.hpp"

#include "strategies/teams/libero/situation/interception.hpp"

namespace fulbito::libero {

const Shot& shotOf(const Picture& picture, int robot, ShotMemory& memory) {
  if (memory.now) return *memory.now;
  constexpr double kClose = 0.10;       // [m] from here the robot steers by the ball as it is
  constexpr double kAhead = 0.03;       // [s] that it then looks ahead
  constexpr double kBehindLine = 0.02;  // [m] of the target
  const RobotState& self = picture.own(robot);
  const BallState& now = picture.ball.now();
  const bool close = squaredNorm(picture.ballFrom(robot)) < kClose * kClose;
  const auto& known = picture.interceptions[static_cast<std::size_t>(robot)];
  const Vec2 ball = close   ? now.position + now.velocity * kAhead
                    : known ? known->ball
                            : interception(picture, self).ball;
  memory.target_y = openMouth(picture, ball, self.pose.position.y, memory.target_y);
  const Vec2 target{picture.pitch.half_length + kBehindLine, memory.target_y};
  return memory.now.emplace(Shot{ball, target, aimAt(picture.pitch, ball, target)});
}

}  // namespace fulbito::libero
