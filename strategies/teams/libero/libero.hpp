// Private header of strategies: not installed.
#pragma once

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// The flagship: one striker, a support and a keeper who change roles as the ball asks (docs/libero.md).
TeamInfo liberoInfo();

}  // namespace fulbito
