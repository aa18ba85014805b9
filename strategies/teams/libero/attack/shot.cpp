#include "strategies/teams/libero/attack/shot.hpp"

#include "strategies/teams/libero/situation/interception.hpp"

namespace fulbito::libero {

Vec2 shotBall(const Picture& picture, int robot) {
  const Pitch& pitch = picture.pitch;
  // From here the robot steers by the ball as it is after the two ticks that a command needs.
  const double close = pitch.touch + pitch.ball_radius;
  const BallState& now = picture.ball.now();
  const auto& known = picture.interceptions[static_cast<std::size_t>(robot)];
  if (squaredNorm(picture.ballFrom(robot)) < close * close)
    return now.position + now.velocity * (2 * pitch.tick);
  return known ? known->ball : interception(picture, picture.own(robot)).ball;
}

const Shot& shotOf(const Picture& picture, int robot, ShotMemory& memory) {
  if (memory.now) return *memory.now;
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = shotBall(picture, robot);
  memory.target_y = openMouth(picture, ball, picture.own(robot).pose.position.y, memory.target_y);
  const Vec2 target{pitch.half_length + pitch.ball_radius, memory.target_y};
  return memory.now.emplace(Shot{ball, target, aimAt(pitch, ball, target)});
}

}  // namespace fulbito::libero
