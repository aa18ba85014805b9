// Private header of replays/render: not installed.
#pragma once

#include <string>

#include "engine/core/robot_model.hpp"
#include "replays/render/field_view.hpp"
#include "replays/render/match_style.hpp"

namespace fulbito {

/// The mark of a team, which needs no colour: a disc for blue, a diamond for yellow. `size` is its radius
/// [px].
void drawTeamMark(Canvas& canvas, Vec2 centre, double size, TeamId team, Colour colour);

/// A robot from above: its wheels, its front, its number on its team's mark. Without a team it has no number.
void drawRobot(const FieldView& view, const RobotModel& robot, const Pose2& pose, std::optional<RobotId> id,
               const MatchStyle& style);
/// A ball with a highlight.
void drawMatchBall(const FieldView& view, Vec2 place, double radius, const MatchStyle& style);

}  // namespace fulbito
