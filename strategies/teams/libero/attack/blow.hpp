// Private header of strategies: not installed.
#pragma once

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// The direction of the blow that sends a ball of velocity `moving` along the aim's, as far as a robot at
/// `robot` can be in place for it: to go round a ball that rolls across costs a second, in which it is gone.
/// Then the blow is turned toward the robot's own way to the ball, if that leads up the field.
Vec2 blowInTime(Vec2 robot, const Aim& aim, Vec2 moving);

/// The aim's blow, turned as little as the bodies about the ball demand; `held` keeps the choice.
Vec2 openBlow(const Picture& picture, int robot, const Aim& aim, int& held);

}  // namespace fulbito::libero
