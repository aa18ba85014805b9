#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// A simple team that produces the states of play. A keeper follows the ball on its line, the nearest robot
/// plays the ball forward, and the others move about in the formation. It belongs to the book, so that
/// changes of the built-in teams change no start.
TeamChoice sparringTeam();

}  // namespace fulbito
