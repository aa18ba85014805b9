#pragma once

#include <vector>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// The sparring teams, each a school of play, in the order of docs/strategies.md: those to tune against, then
/// those that only validate.
std::vector<TeamInfo> sparringTeams();

}  // namespace fulbito
