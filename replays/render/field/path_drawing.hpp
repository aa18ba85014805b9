#pragma once

#include <span>

#include "fulbito/picture.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// Draws all paths of a picture in their series colours, with their footprints. Overlapping paths come to the
/// top in turn, so that all colours of a bundle are visible. Failed paths lie above the others, which show
/// through their gaps.
void drawPaths(const FieldView& view, const RobotModel& robot, const std::vector<DrawnPath>& paths);

/// Draws the arrows of a heading field, faintly.
void drawArrows(const FieldView& view, const FieldArrows& arrows);

/// Draws the marks on the paths. A cross marks where a run failed, a ringed cross where the robot touched
/// something. A badge has the path's number (1, 2, ...) and lies where the path is farthest from the others.
void drawPathMarks(const FieldView& view, const std::vector<DrawnPath>& paths);

/// The colour of path `index`.
Colour pathColour(const DrawnPath& path, std::size_t index);
/// Draws the round mark with the number of path `index`, as used on the path and in the legend.
void drawBadge(const FieldView& view, Vec2 centre, std::size_t index, Colour colour);
/// Draws a ringed cross, for a place where a robot touched something.
void drawTouch(const FieldView& view, Vec2 centre, Colour colour);
/// Draws the dark core of a hollow path.
void drawCore(const FieldView& view, std::span<const Vec2> line);
/// Draws a cross, for a place where a run failed.
void drawCross(const FieldView& view, Vec2 centre, double size, Colour colour);
/// Thickness [px] of the paths.
double pathThickness(const FieldView& view);
/// The dashes of a failed path.
Dashes failedDashes(const FieldView& view);

}  // namespace fulbito
