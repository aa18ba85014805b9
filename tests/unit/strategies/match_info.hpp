#pragma once

#include "fulbito/models.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::test {

/// The 3v3 game on standard physics.
inline MatchInfo matchInfo() {
  MatchInfo info;
  info.field = *loadField("vsss-3v3");
  const RobotPreset preset = *loadRobot("vsss");
  info.robot = preset.robot;
  info.ball = preset.ball;
  info.physics = *loadPhysics("standard");
  return info;
}

}  // namespace fulbito::test
