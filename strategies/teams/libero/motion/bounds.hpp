#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Which areas a robot must keep out of.
struct Closed {
  bool own = false;
  bool theirs = false;
};

/// `wanted`, unless after a tick of it the robot could not stop before a closed area: then it goes on along
/// the edge, or brakes; one that is in already leaves by the quickest way.
RobotCommand keptOut(const Picture& picture, int robot, Closed closed, Twist wanted);

/// [m] how near to our area's line the centre may come: a defender is inside with more than half of its body.
inline constexpr double kOwnMargin = 0.015;
/// [m] more than that while an opponent comes at it and would push it in.
inline constexpr double kPressedMargin = 0.12;
/// [m] the same at theirs, where any part counts, beyond the body's circle.
inline constexpr double kTheirMargin = 0.008;

}  // namespace fulbito::libero
