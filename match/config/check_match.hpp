// Private header of match: not installed.
#pragma once

#include "engine/core/base/result.hpp"
#include "match/config/match_config.hpp"

namespace fulbito {

/// Checks everything of a match's configuration that no other function checks. Errors: kUsage naming the
/// value and its range.
Result<void> checkMatch(const MatchConfig& config);

}  // namespace fulbito
