#include "strategies/skills/quick_twist.hpp"

#include "navigation/followers/limiter.hpp"

namespace fulbito {

RobotCommand quickTwist(const RobotModel& model, const RobotState& robot, Twist wanted, double dt) {
  // The wheels' own sensors: velocities that a camera gives would make the wheels follow its noise.
  const Twist now = forwardKinematics(model, robot.wheels);
  return RobotCommand::byWheels(inverseKinematics(model, limitTwist(model, now, wanted, dt)));
}

}  // namespace fulbito
