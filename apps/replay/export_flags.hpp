#pragma once

#include "apps/replay/replay.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito::app {

/// Checks that every flag of `replay export` applies to a requested product. Errors: kUsage naming the flags.
Result<void> checkExportFlags(const ReplayExportCommand& options);

}  // namespace fulbito::app
