#pragma once

#include "fulbito/models.hpp"

namespace fulbito::test {

/// @{ The program's presets, so that the models' tests judge what users get.
inline RobotPreset vsssPreset() { return loadRobot("vsss").value(); }
inline RobotPreset firasimPreset() { return loadRobot("firasim").value(); }
inline RobotPreset paperPreset() { return loadRobot("jung-lee-2015").value(); }
inline PhysicsProfile fastPhysics() { return loadPhysics("fast").value(); }
inline PhysicsProfile standardPhysics() { return loadPhysics("standard").value(); }
inline PhysicsProfile faithfulPhysics() { return loadPhysics("faithful").value(); }
/// @}

}  // namespace fulbito::test
