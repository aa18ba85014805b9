#pragma once

#include <array>
#include <optional>
#include <string>

#include "fulbito/models.hpp"
#include "replays/render/colours/match_style.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// Draws the mark of a team, which is recognisable without colour: a disc for blue, a diamond for yellow.
/// `size` is its radius [px].
void drawTeamMark(Canvas& canvas, Vec2 centre, double size, TeamId team, Colour colour);

/// The corners [px] of the parts of a robot.
struct RobotShape {
  std::array<Vec2, 8> shadow, edge, body;
  std::array<std::array<Vec2, 4>, 2> wheels;
  std::array<Vec2, 4> nose;
  Vec2 badge;         ///< centre of the mark with the number [px]
  double badge_size;  ///< radius of the mark [px] if it is a disc
  double digit_size;  ///< size of the number's letters [px]; 0: too small to be readable
};
RobotShape shapeOf(const FieldView& view, const RobotModel& robot, const Pose2& pose);

/// Radius of a team's mark relative to a disc's, so that the number fits.
double markFactor(TeamId team);
/// Distance from the middle of a digit to its baseline, relative to the text size.
inline constexpr double kDigitDrop = 0.365;

const TeamColours& coloursOf(std::optional<RobotId> id, const MatchStyle& style);

/// Draws a robot from above: wheels, front, and its number on the team's mark. Without a team it has no
/// number.
void drawRobot(const FieldView& view, const RobotModel& robot, const Pose2& pose, std::optional<RobotId> id,
               const MatchStyle& style);
/// Draws a ball with a highlight.
void drawMatchBall(const FieldView& view, Vec2 place, double radius, const MatchStyle& style);

}  // namespace fulbito
