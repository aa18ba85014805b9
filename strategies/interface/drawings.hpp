#pragma once

#include <span>
#include <string>
#include <vector>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// @{ Append a line, a circle or a robot's name to `drawings`, in the team's frame.
inline void addLine(std::vector<DebugDrawing>& drawings, Vec2 from, Vec2 to) {
  drawings.push_back({DebugDrawing::Kind::kLine, from, to, 0.0, {}});
}

inline void addCircle(std::vector<DebugDrawing>& drawings, Vec2 centre, double radius) {
  drawings.push_back({DebugDrawing::Kind::kCircle, centre, {}, radius, {}});
}

/// A robot's role, next to its body.
inline void addName(std::vector<DebugDrawing>& drawings, Vec2 robot, const char* name) {
  constexpr double kBeside = 0.075;  // [m] above the robot's centre, clear of the body at any heading
  drawings.push_back({DebugDrawing::Kind::kText, robot + Vec2{0.0, kBeside}, {}, 0.0, name});
}
/// @}

}  // namespace fulbito
