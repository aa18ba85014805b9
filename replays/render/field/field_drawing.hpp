#pragma once

#include <array>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/models.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// Width of the walls around the field, seen from above [m].
inline constexpr double kDrawnWall = 0.025;

/// The field colours of the pictures of trials.
FieldColours defaultFieldColours();

/// Whether a field is a soccer field: it has goals or a centre circle. Rooms and halls have neither, and no
/// lines.
bool isPitch(const FieldGeometry& field);

/// Draws floor, walls and, on a pitch, lines.
void drawField(const FieldView& view, const FieldGeometry& field,
               const FieldColours& colours = defaultFieldColours());
/// @{ The two parts of drawField.
void drawFloorAndWalls(const FieldView& view, const FieldGeometry& field, const FieldColours& colours);
void drawFieldLines(const FieldView& view, const FieldGeometry& field, const FieldColours& colours);
/// @}
/// The colour of an obstacle, by its kind of motion.
Colour obstacleColour(const ObstacleSpec& obstacle);
/// Draws only the shape of an obstacle, at its pose.
void drawObstacleBody(const FieldView& view, const ObstacleSpec& obstacle);
/// Draws an obstacle at its start; a moving one also with its path.
void drawObstacle(const FieldView& view, const ObstacleSpec& obstacle);
/// Draws the robot's body and heading at `start`.
void drawStart(const FieldView& view, const RobotModel& robot, const Pose2& start);
/// @{ Draws the target with its tolerance circle, and with an arrow if an arrival heading is wanted.
void drawGoal(const FieldView& view, const Layout& layout);
void drawGoal(const FieldView& view, const Layout& layout, Colour colour);
/// @}

/// The dash pattern of a stroke [px]: `on` of every `period` are drawn; the stroke begins `phase` into a
/// period.
struct Dashes {
  double period;
  double on;
  double phase = 0.0;
};
void drawDashed(Canvas& canvas, std::span<const Vec2> points, Dashes dashes, double thickness, Colour colour);

/// A filled arrow head [px] whose tip is `tip`, pointing along the unit vector `direction`.
void drawArrowHead(Canvas& canvas, Vec2 tip, Vec2 direction, double size, Colour colour);

/// Corners [m] of a body of `length` x `width` at a pose.
std::array<Vec2, 4> bodyCorners(const Pose2& pose, double length, double width);

}  // namespace fulbito
