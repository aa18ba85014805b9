#pragma once

#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Distance [m] between arrows in a picture of the rectangle from `low` to `high` [m].
double arrowSpacing(Vec2 low, Vec2 high);

/// Headings of the trial's method at the start, on a grid over that rectangle, for points on the field and
/// outside obstacles. Empty if the method is not a heading field. Errors: those of the method's parameters.
Result<std::vector<Pose2>> fieldArrows(const TrialConfig& config, Vec2 low, Vec2 high);

}  // namespace fulbito
