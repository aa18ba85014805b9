// Private header of strategies: not installed.
#pragma once

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// Everyone at the ball, and the ball at the opponents' goal.
TeamInfo chaserInfo();

}  // namespace fulbito
