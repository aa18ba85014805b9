#pragma once

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"

namespace fulbito {

/// Checks that the rules fit field and ball: the field has goals, the ball fits through them, and all ball
/// spots of the rules are inside. Errors: kBadInput naming rules, field and key.
Result<void> checkField(const Rules& rules, const FieldGeometry& field, const BallModel& ball);

}  // namespace fulbito
