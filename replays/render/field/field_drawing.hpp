#pragma once

#include <array>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/models.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// Width [m] of the walls' tops around the field.
inline constexpr double kDrawnWall = 0.025;

/// Those of the pictures of trials.
FieldColours defaultFieldColours();

/// Whether a field is one of soccer: it has goals, or a centre circle. Rooms and halls are not, and have no
/// lines.
bool isPitch(const FieldGeometry& field);

/// Floor, walls and, on a pitch, lines.
void drawField(const FieldView& view, const FieldGeometry& field,
               const FieldColours& colours = defaultFieldColours());
/// @{ The two parts of drawField.
void drawFloorAndWalls(const FieldView& view, const FieldGeometry& field, const FieldColours& colours);
void drawFieldLines(const FieldView& view, const FieldGeometry& field, const FieldColours& colours);
/// @}
/// Colours of an obstacle.
Colour obstacleColour(const ObstacleSpec& obstacle);
/// Its shape alone, at its pose.
void drawObstacleBody(const FieldView& view, const ObstacleSpec& obstacle);
/// The obstacle as it is at the start; a moving one also with its path.
void drawObstacle(const FieldView& view, const ObstacleSpec& obstacle);
/// The robot's body and heading at `layout.start`.
void drawStart(const FieldView& view, const RobotModel& robot, const Pose2& start);
/// @{ A target with its tolerance circle; an arrow when an arrival heading is wanted.
void drawGoal(const FieldView& view, const Layout& layout);
void drawGoal(const FieldView& view, const Layout& layout, Colour colour);
/// @}

/// A stroke in pieces: `on` pixels drawn of every `period`, from the pixel `phase` of the first period.
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
