#pragma once

#include "apps/common/commands.hpp"

namespace fulbito::app {

/// Runs `fulbito compare --map` and returns the exit code.
int compareMap(const CompareOptions& options);

}  // namespace fulbito::app
