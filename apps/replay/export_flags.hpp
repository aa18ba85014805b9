// Private header of apps: not installed.
#pragma once

#include "apps/replay/replay.hpp"
#include "engine/core/base/result.hpp"

namespace fulbito::app {

/// What is wrong with the flags of `replay export` taken together: one that none of the products heeds, two
/// products in one file, a product in place of the recording. Errors: kUsage naming the flags.
Result<void> checkExportFlags(const ReplayExportCommand& options);

}  // namespace fulbito::app
