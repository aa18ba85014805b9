#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bridge/wire/messages.hpp"

namespace fulbito::wire {

/// A frame of vision as a world: its robots in the order of ids, and the ball.
struct SeenWorld {
  std::vector<RobotId> ids;  ///< of the robots
  std::vector<RobotState> robots;
  BallState ball;
  int unknown = 0;  ///< robots that a match of these teams does not have
};

/// Sorts out a frame. Of a robot that it has twice, the first counts. Empty: a value is not finite.
std::optional<SeenWorld> seenWorld(const Vision& vision, int team_size);

/// Checks that a server's field is that of the rules. Errors: kUsage naming both.
Result<void> checkField(const Vision& vision, const FieldGeometry& field, const std::string& rules);

}  // namespace fulbito::wire
