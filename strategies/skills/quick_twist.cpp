#include "strategies/skills/quick_twist.hpp"

#include "navigation/followers/limiter.hpp"

namespace fulbito {

RobotCommand quickTwist(const RobotModel& model, const RobotState& robot, Twist wanted, double dt) {
  return RobotCommand::byWheels(inverseKinematics(model, limitTwist(model, bodyTwist(robot), wanted, dt)));
}

}  // namespace fulbito
