#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito::sparring {

/// @{ The sparring teams, each a school of play (docs/strategies.md). Teams are tuned against the first six.
TeamInfo univectorInfo();
TeamInfo twinsInfo();
TeamInfo markerInfo();
TeamInfo blockInfo();
TeamInfo counterInfo();
TeamInfo presserInfo();
/// @}

/// @{ Teams that only validate: nothing is tuned against them.
TeamInfo dribblerInfo();
TeamInfo kickerInfo();
TeamInfo spinnerInfo();
TeamInfo sweeperInfo();
/// @}

}  // namespace fulbito::sparring
