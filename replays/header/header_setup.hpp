#pragma once

#include "fulbito/models.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {

/// A header with everything that follows from the world: rates, the step of commands (0 if the profile has no
/// step or one that is too fine for whole numbers) and this build. The caller fills in bodies and recipe.
RecordingHeader headerFor(RecordingKind kind, const PhysicsProfile& physics);

}  // namespace fulbito
