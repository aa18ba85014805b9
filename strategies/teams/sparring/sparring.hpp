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

}  // namespace fulbito::sparring
