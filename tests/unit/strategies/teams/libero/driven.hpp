#pragma once

#include <utility>

#include "fulbito/strategy.hpp"
#include "navigation/followers/limiter.hpp"

namespace fulbito::test {

/// The robot one tick after a twist command, with the limits of the match.
inline RobotState driven(const MatchInfo& info, const RobotState& robot, Twist twist) {
  const double dt = info.physics.controlPeriod();
  const Twist limited = limitTwist(steady(info.robot), bodyTwist(robot), twist, dt);
  return rolledForward(info.robot, robot, saturate(info.robot, inverseKinematics(info.robot, limited)), dt);
}

}  // namespace fulbito::test
