#pragma once

#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "referee/rules/rules.hpp"

namespace fulbito {

/// Whether a match by these rules can be played on the field with the ball: there are goals, the ball goes
/// through them, and every spot on which the rules put it is inside. Errors: kBadInput naming rules, field
/// and key.
Result<void> checkField(const Rules& rules, const FieldGeometry& field, const BallModel& ball);

}  // namespace fulbito
