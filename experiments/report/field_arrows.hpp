#pragma once

#include <vector>

#include "experiments/trials/trial.hpp"

namespace fulbito {

/// Distance [m] between the arrows of a picture that shows the rectangle from `low` to `high` [m].
double arrowSpacing(Vec2 low, Vec2 high);

/// What the trial's method wants at the start, on a grid over that rectangle as far as it is on the field and
/// outside of obstacles; nothing for a method that is no heading field. Errors: of the method's parameters.
Result<std::vector<Pose2>> fieldArrows(const TrialConfig& config, Vec2 low, Vec2 high);

}  // namespace fulbito
