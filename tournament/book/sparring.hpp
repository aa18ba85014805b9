#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// A simple team that makes states of play: a keeper follows the ball on its line, the nearest robot plays
/// the ball forward, the others drive about in the formation. It is part of the book, so that changes of the
/// built-in teams change no start.
TeamChoice sparringTeam();

}  // namespace fulbito
