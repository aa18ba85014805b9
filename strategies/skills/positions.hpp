#pragma once

#include <span>

#include "engine/core/models/field_places.hpp"
#include "strategies/prediction/ball_prediction.hpp"

/// Places of roles on the field, in the team's frame (own goal at -x); docs/skills.md, Places.
namespace fulbito {

/// The middle of the own goal line.
constexpr Vec2 ownGoal(const FieldGeometry& field) { return {-field.length / 2, 0.0}; }
/// The middle of the opponents' goal line.
constexpr Vec2 opponentGoal(const FieldGeometry& field) { return {field.length / 2, 0.0}; }

/// The keeper's place. If the ball goes to the goal mouth, widened by `margin` [m], it is where the predicted
/// ball crosses the keeper's line, `depth` [m] in front of the goal line. Otherwise it is the equal-gap
/// point. |y| is at most `farthest` [m].
Vec2 keeperPoint(const FieldGeometry& field, const BallPrediction& ball, double depth, double farthest,
                 double margin = 0.03);

/// A second defender's place: on the line from the ball to the own goal, `away` [m] from the ball. It is
/// never beyond the own area's front.
Vec2 shadowPoint(const FieldGeometry& field, Vec2 ball, double away);

/// The place for rebounds from the opponents' keeper and end wall: on the far side from the ball.
Vec2 reboundSpot(const FieldGeometry& field, Vec2 ball);

/// The best target of a clearance near the own goal: at the nearer side wall, upfield, at least 30 degrees
/// off the goal line. Of several such points it is the one with the widest gap to `opponents`.
Vec2 clearanceTarget(const FieldGeometry& field, Vec2 ball, std::span<const Vec2> opponents);

}  // namespace fulbito
