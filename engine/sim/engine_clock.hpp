#pragma once

namespace fulbito {

/// Replaces Box2D's b2Timer by one that reads no clock. Box2D reads the clock several times per step to
/// profile itself, which can cost more than the step. Calling this makes the linker of every program use the
/// replacement.
void keepEngineClockOut();

}  // namespace fulbito
