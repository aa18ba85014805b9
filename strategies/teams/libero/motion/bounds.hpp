#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Which areas a robot must keep out of.
struct Closed {
  bool own = false;
  bool theirs = false;
};

/// Returns `wanted` if the robot can drive it for one tick and then stop in front of the closed areas.
/// Otherwise the robot drives along the edge or brakes. A robot inside an area leaves it by the quickest way.
RobotCommand keptOut(const Picture& picture, int robot, Closed closed, Twist wanted);

/// [m] least distance of the centre from the own area; a defender is inside with more than half of its body.
inline constexpr double kOwnMargin = 0.015;
/// [m] added to that while an opponent would push the robot in.
inline constexpr double kPressedMargin = 0.12;
/// [m] least distance of the body's circle from the opponents' area, where any part of the body counts as
/// inside.
inline constexpr double kTheirMargin = 0.008;

}  // namespace fulbito::libero
