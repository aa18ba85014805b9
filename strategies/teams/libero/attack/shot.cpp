#include "strategies/teams/libero/attack/shot.hpp"

#include "strategies/teams/libero/situation/interception.hpp"

namespace fulbito::libero {

const Shot& shotOf(const Picture& picture, int robot, ShotMemory& memory) {
  if (memory.now) return *memory.now;
  const Pitch& pitch = picture.pitch;
  // From here the robot steers by the ball as it is after the two ticks that a command needs.
  const double close = pitch.touch + pitch.ball_radius;
  const RobotState& self = picture.own(robot);
  const BallState& now = picture.ball.now();
  const auto& known = picture.interceptions[static_cast<std::size_t>(robot)];
  const Vec2 ball = squaredNorm(picture.ballFrom(robot)) < close * close
                        ? now.position + now.velocity * (2 * pitch.tick)
                    : known ? known->ball
                            : interception(picture, self).ball;
  memory.target_y = openMouth(picture, ball, self.pose.position.y, memory.target_y);
  const Vec2 target{pitch.half_length + pitch.ball_radius, memory.target_y};
  return memory.now.emplace(Shot{ball, target, aimAt(pitch, ball, target)});
}

}  // namespace fulbito::libero
