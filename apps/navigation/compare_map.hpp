#pragma once

#include "apps/common/commands.hpp"

namespace fulbito::app {

/// `fulbito compare --map`: returns the exit code.
int compareMap(const CompareOptions& options);

}  // namespace fulbito::app
