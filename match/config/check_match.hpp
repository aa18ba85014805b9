#pragma once

#include "fulbito/detail/values.hpp"
#include "fulbito/match.hpp"

namespace fulbito {

/// Checks the parts of a match's configuration that no other function checks. Errors: kUsage naming the value
/// and its range.
Result<void> checkMatch(const MatchConfig& config);

}  // namespace fulbito
