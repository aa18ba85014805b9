#pragma once

#include "fulbito/detail/values.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// Checks that every value is finite, in its range and inside the field; the error names the robot, ball or
/// obstacle (counted from 0) and the value.
Result<void> checkConfig(const WorldConfig& config);

}  // namespace fulbito
