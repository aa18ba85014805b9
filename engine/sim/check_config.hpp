// Private header of engine/sim: not installed.
#pragma once

#include "engine/core/base/result.hpp"
#include "engine/sim/world.hpp"

namespace fulbito {

/// Checks that every value is finite, in its range and inside the field; the error names the robot, ball or
/// obstacle (counted from 0) and the value.
Result<void> checkConfig(const WorldConfig& config);

}  // namespace fulbito
