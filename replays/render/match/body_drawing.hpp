#pragma once

#include <array>
#include <optional>
#include <string>

#include "fulbito/models.hpp"
#include "replays/render/colours/match_style.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// The mark of a team, which needs no colour: a disc for blue, a diamond for yellow. `size` is its radius
/// [px].
void drawTeamMark(Canvas& canvas, Vec2 centre, double size, TeamId team, Colour colour);

/// The corners [px] of the parts of a robot.
struct RobotShape {
  std::array<Vec2, 8> shadow, edge, body;
  std::array<std::array<Vec2, 4>, 2> wheels;
  std::array<Vec2, 4> nose;
  Vec2 badge;         ///< centre of the mark with the number
  double badge_size;  ///< its radius, of a disc
  double digit_size;  ///< of the number's letters; 0: too small to be read
};
RobotShape shapeOf(const FieldView& view, const RobotModel& robot, const Pose2& pose);

/// How much larger than a disc's radius that of a team's mark is, so that a number fits.
double markFactor(TeamId team);
/// From the middle of a digit to its baseline, in sizes of its letters.
inline constexpr double kDigitDrop = 0.365;

const TeamColours& coloursOf(std::optional<RobotId> id, const MatchStyle& style);

/// A robot from above: its wheels, its front, its number on its team's mark. Without a team it has no number.
void drawRobot(const FieldView& view, const RobotModel& robot, const Pose2& pose, std::optional<RobotId> id,
               const MatchStyle& style);
/// A ball with a highlight.
void drawMatchBall(const FieldView& view, Vec2 place, double radius, const MatchStyle& style);

}  // namespace fulbito
