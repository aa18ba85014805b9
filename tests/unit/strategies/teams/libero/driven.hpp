#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/skills/quick_twist.hpp"

namespace fulbito::test {

/// The robot one tick after a twist, as libero drives it.
inline RobotState driven(const MatchInfo& info, const RobotState& robot, Twist twist) {
  const double dt = info.physics.controlPeriod();
  const WheelSpeeds wheels = quickTwist(info.robot, robot, twist, dt).wheels;
  return rolledForward(info.robot, robot, saturate(info.robot, wheels), dt);
}

/// The twist in one tick's reach for which a robot's command sets the wheels.
inline Twist twistOf(const MatchInfo& info, const RobotCommand& command) {
  return forwardKinematics(info.robot, command.wheels);
}

}  // namespace fulbito::test
