#include "referee/geometry/ball_gap.hpp"

#include "engine/core/models/shapes.hpp"

namespace fulbito {

std::optional<double> ballGap(const RobotModel& robot, const Pose2& pose, const BallModel& ball, Vec2 place,
                              double most) {
  const double reach = norm({robot.length / 2, robot.width / 2}) + ball.radius + most;
  if (squaredNorm(place - pose.position) > reach * reach) return std::nullopt;
  const double gap = clearance(bodyOf(robot, pose), place, ball.radius);
  if (gap > most) return std::nullopt;
  return gap;
}

}  // namespace fulbito
