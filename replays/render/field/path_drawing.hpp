#pragma once

#include <span>

#include "fulbito/picture.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// All paths of a picture, each in its series colour, with their footprints. Paths that lie on each other
/// come to the top in turn, so that a bundle shows all its colours; failed ones lie above the others, which
/// show through their gaps.
void drawPaths(const FieldView& view, const RobotModel& robot, const std::vector<DrawnPath>& paths);

/// The arrows of a heading field, faint.
void drawArrows(const FieldView& view, const FieldArrows& arrows);

/// What stands on the paths: a cross where a run failed, a ringed one where it touched, and the number of
/// each path (1, 2, ...) on a badge where it runs farthest from the others.
void drawPathMarks(const FieldView& view, const std::vector<DrawnPath>& paths);

/// The colour of path `index`.
Colour pathColour(const DrawnPath& path, std::size_t index);
/// The round mark with the number of path `index` that path and legend share.
void drawBadge(const FieldView& view, Vec2 centre, std::size_t index, Colour colour);
/// A ringed cross where a robot touched something.
void drawTouch(const FieldView& view, Vec2 centre, Colour colour);
/// The dark core of a hollow path.
void drawCore(const FieldView& view, std::span<const Vec2> line);
/// A cross where a run failed.
void drawCross(const FieldView& view, Vec2 centre, double size, Colour colour);
/// Thickness [px] of the paths.
double pathThickness(const FieldView& view);
/// How a failed path is dashed.
Dashes failedDashes(const FieldView& view);

}  // namespace fulbito
