// Private header of engine/sim: not installed.
#pragma once

namespace fulbito {

/// Box2D reads the clock several times a step to profile itself, which costs more than many a step's work.
/// The library's own b2Timer, which reads no clock, replaces it. Calling this makes every program that links
/// the library take that one.
void keepEngineClockOut();

}  // namespace fulbito
