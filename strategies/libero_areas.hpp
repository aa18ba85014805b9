// Private header of strategies: not installed.
#pragma once

#include "strategies/libero_motion.hpp"

namespace fulbito::libero {

/// Whether `p` lies in our goal area, widened by `margin` [m]; the arc counts as a box.
bool inOwnArea(const Pitch& pitch, Vec2 p, double margin = 0.0);
/// The same of theirs.
bool inTheirArea(const Pitch& pitch, Vec2 p, double margin = 0.0);

/// `p` moved out of our area by the shortest way; stays where it is outside.
Vec2 outOfOwnArea(const Pitch& pitch, Vec2 p, double margin);
Vec2 outOfTheirArea(const Pitch& pitch, Vec2 p, double margin);

/// Which areas a robot must keep out of.
struct Closed {
  bool own = false;
  bool theirs = false;
};

/// `wanted`, unless it would carry the robot into a closed area before it could stop: then it turns off or
/// leaves by the shortest way.
Twist keptOut(const Pitch& pitch, const RobotState& robot, Closed closed, Twist wanted);

}  // namespace fulbito::libero
