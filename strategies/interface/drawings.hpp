#pragma once

#include <span>
#include <string>
#include <vector>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// @{ Append a line, a circle, a robot's name or a remark to `drawings`, in the team's frame.
inline void addLine(std::vector<DebugDrawing>& drawings, Vec2 from, Vec2 to) {
  drawings.push_back({DebugDrawing::Kind::kLine, from, to, 0.0, {}});
}

inline void addCircle(std::vector<DebugDrawing>& drawings, Vec2 centre, double radius) {
  drawings.push_back({DebugDrawing::Kind::kCircle, centre, {}, radius, {}});
}

inline constexpr double kBeside = 0.075;  ///< [m] from the robot's centre to words, clear of its body

/// A robot's role, next to its body.
inline void addName(std::vector<DebugDrawing>& drawings, Vec2 robot, const char* name) {
  drawings.push_back({DebugDrawing::Kind::kText, robot + Vec2{0.0, kBeside}, {}, 0.0, name});
}

/// A remark about a robot, on the other side of its body than its name.
inline void addRemark(std::vector<DebugDrawing>& drawings, Vec2 robot, const char* remark) {
  drawings.push_back({DebugDrawing::Kind::kText, robot - Vec2{0.0, kBeside}, {}, 0.0, remark});
}
/// @}

}  // namespace fulbito
