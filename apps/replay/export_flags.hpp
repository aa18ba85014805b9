#pragma once

#include "apps/replay/replay.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito::app {

/// Checks the combination of the flags of `replay export`: every flag applies to a requested product, and no
/// two files are the same. Errors: kUsage naming the flags.
Result<void> checkExportFlags(const ReplayExportCommand& options);

}  // namespace fulbito::app
