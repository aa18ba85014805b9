// Private header of strategies: not installed.
#pragma once

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// The textbook team of the papers' school: fixed roles and a field that leads to the ball with the right
/// heading.
TeamInfo classicInfo();

}  // namespace fulbito
