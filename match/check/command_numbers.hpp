#pragma once

#include <vector>

#include "fulbito/detail/math.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// What a robot's command asks for, as numbers that may be compared one by one: equal commands have equal
/// numbers, however they are written.
inline std::vector<double> commandNumbers(const RobotCommand& robot) {
  using Kind = RobotCommand::Kind;
  const double kind = static_cast<double>(robot.kind);
  if (robot.kind == Kind::kWheels) return {kind, robot.wheels.left, robot.wheels.right};
  if (robot.kind == Kind::kTwist) return {kind, robot.twist.linear, robot.twist.angular};
  const GoTo& go_to = robot.go_to;
  // A robot that comes to rest with either end leading is asked for an axis, not for a direction.
  const double times = go_to.stop && go_to.either_front ? 2.0 : 1.0;
  const double sine = go_to.heading ? math::sin(times * *go_to.heading) : 0.0;
  const double cosine = go_to.heading ? math::cos(times * *go_to.heading) : 0.0;
  return {kind,   go_to.position.x,        go_to.position.y,  sine,
          cosine, double(go_to.navigator), double(go_to.stop)};
}

}  // namespace fulbito
