// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 7.1: the whole ball (or its centre) is past the goal line.
std::optional<Finding> detectGoal(const DetectorInput& input, const TouchMemory& touches);

}  // namespace fulbito
