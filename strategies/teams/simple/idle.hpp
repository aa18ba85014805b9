// Private header of strategies: not installed.
#pragma once

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// Nobody moves: what a striker is tried against first.
TeamInfo idleInfo();

}  // namespace fulbito
