#pragma once

#include <optional>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

/// Law 13: a robot that presses on the opponents' keeper in its area without disputing the ball charges it,
/// and the ball is theirs. So the keeper is an obstacle to all robots that are not at the ball.
namespace fulbito::libero {

/// [s] after a touch of the ball in which a robot still disputes it. Referees allow 0.5 s; of that it takes
/// 0.2 s to stop from full speed, and some more to come off a keeper that presses.
inline constexpr double kDisputes = 0.15;

/// Whether `robot` touches the ball.
bool atBall(const Pitch& pitch, const RobotState& robot, Vec2 ball);

/// The way to `target` round a keeper that bars it; empty where none does, or the robot disputes the ball.
std::optional<Twist> roundKeeper(const Picture& picture, int robot, Vec2 target);

/// What `robot` does instead of `wanted` where that would end in a keeper: it stops in time or turns off, and
/// leaves one that it touches. Empty: as wanted.
std::optional<RobotCommand> clearOfKeeper(const Picture& picture, int robot, Twist wanted);

}  // namespace fulbito::libero
