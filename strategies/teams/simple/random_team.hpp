// Private header of strategies: not installed.
#pragma once

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// Everyone drives about at random: what the referee and the engine are tried with.
TeamInfo randomTeamInfo();

}  // namespace fulbito
