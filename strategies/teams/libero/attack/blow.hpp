#pragma once

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// The direction of the blow that sends a ball of velocity `moving` along the aim's, as far as a robot at
/// `robot` can be in place for it: to go round a ball that rolls across costs a second, in which it is gone.
/// Then the blow is turned toward the robot's own way to the ball, if that leads up the field.
Vec2 blowInTime(Vec2 robot, const Aim& aim, Vec2 moving);

/// The strike direction nearest to the aim's whose run-up and exit are free of bodies and walls. `previous`
/// is the index of the one chosen last tick, which has an advantage; it is set to the new one's.
Vec2 clearStrikeDirection(const Picture& picture, int robot, const Aim& aim, int& previous);

}  // namespace fulbito::libero
