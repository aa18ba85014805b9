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

}  // namespace fulbito::libero
