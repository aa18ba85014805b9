#pragma once

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// The direction of the strike that sends a ball with the velocity `moving` along the aim's direction, as far
/// as a robot at `robot` can be in place for it. Driving round a ball that rolls takes a second, and the ball
/// is gone by then. In that case the strike turns toward the robot's own way to the ball, if that leads
/// upfield. Only robots that can shove overtake a ball that runs ahead of them.
Vec2 blowInTime(const Pitch& pitch, Vec2 robot, const Aim& aim, Vec2 moving);

/// The strike direction nearest to the aim's whose run-up and exit are free of bodies and walls. `previous`
/// is the index of the last tick's choice, which is preferred; the call updates it.
Vec2 clearStrikeDirection(const Picture& picture, int robot, const Aim& aim, int& previous);

}  // namespace fulbito::libero
