#pragma once

#include <optional>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

/// Law 13: a robot that presses on the opponents' keeper in its area without disputing the ball commits a
/// foul. So the keeper is an obstacle to all robots that are not at the ball.
namespace fulbito::libero {

/// Whether `robot` touches the ball.
bool atBall(const Pitch& pitch, const RobotState& robot, Vec2 ball);

/// What a robot remembers on its way along a keeper. Its wish changes with each small motion, and a robot
/// that chose the way anew in each tick would turn to and fro.
struct SlideMemory {
  double left = 0.0;     ///< [s] for which it keeps the heading
  double heading = 0.0;  ///< [rad]
};

/// What `robot` does instead of `wanted` if that would hit the keeper: it stops in time, drives along it, or
/// leaves a keeper that it touches. Empty: `wanted` is fine, also if the robot is at the ball in half the
/// time in which a contact becomes a foul.
std::optional<RobotCommand> clearOfKeeper(const Picture& picture, int robot, Twist wanted,
                                          SlideMemory& slide);

/// What a robot remembers while it leaves a mate. The best way off changes with each small motion, and a
/// robot that always took it would stand and tremble.
struct YieldMemory {
  double left = 0.0;      ///< [s] for which the command stays
  double touching = 0.0;  ///< [s] for which it has touched a mate
  RobotCommand command;
};

/// Mates yield: what `robot` does instead of `wanted` if that would hit a mate that goes first. A robot at
/// the ball goes first, then the keeper, the striker, and the supports in their order. Any robot leaves
/// a mate that it touches for long: walls, areas or others may hold the mate. Empty: `wanted` is fine.
std::optional<RobotCommand> clearOfMates(const Picture& picture, int robot, Twist wanted,
                                         YieldMemory& memory);

}  // namespace fulbito::libero
