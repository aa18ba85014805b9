#pragma once

#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Distance [m] between arrows in a picture of the rectangle from `low` to `high` [m].
double arrowSpacing(Vec2 low, Vec2 high);

/// The headings that the trial's method wants at the start, on a grid over that rectangle, where it is on the
/// field and outside obstacles. Empty if the method is not a heading field. Errors: of the method's
/// parameters.
Result<std::vector<Pose2>> fieldArrows(const TrialConfig& config, Vec2 low, Vec2 high);

}  // namespace fulbito
