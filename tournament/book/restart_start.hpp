#pragma once

#include "tournament/book/book.hpp"

namespace fulbito {

/// The free ball, penalty or goal kick that a match begins with. Robots stand at the places of the rules,
/// moved to the nearest legal ones. Free balls take turns at the four marks, penalties and goal kicks between
/// the teams. Errors: kBadInput when the field lacks the mark, or has no room for all robots.
Result<RestartCall> restartStart(const StartKey& key, const MatchConfig& match);

}  // namespace fulbito
