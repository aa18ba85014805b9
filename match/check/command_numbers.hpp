#pragma once

#include <vector>

#include "fulbito/detail/math.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// A robot's command as numbers to compare one by one. Commands that ask for the same have equal numbers,
/// whatever their representation.
inline std::vector<double> commandNumbers(const RobotCommand& robot) {
  using Kind = RobotCommand::Kind;
  const double kind = static_cast<double>(robot.kind);
  if (robot.kind == Kind::kWheels) return {kind, robot.wheels.left, robot.wheels.right};
  if (robot.kind == Kind::kTwist) return {kind, robot.twist.linear, robot.twist.angular};
  const GoTo& go_to = robot.go_to;
  // If the robot stops with either end in front, a heading and its opposite are the same: compare twice the
  // angle.
  const double times = go_to.stop && go_to.either_front ? 2.0 : 1.0;
  const double sine = go_to.heading ? math::sin(times * *go_to.heading) : 0.0;
  const double cosine = go_to.heading ? math::cos(times * *go_to.heading) : 0.0;
  return {kind,   go_to.position.x,        go_to.position.y,  sine,
          cosine, double(go_to.navigator), double(go_to.stop)};
}

}  // namespace fulbito
