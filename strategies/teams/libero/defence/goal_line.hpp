#pragma once

#include <optional>

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// [m] from the goal line to the centre of a keeper that stands in its goal.
inline double keeperDepth(const Pitch& pitch) { return pitch.robot_half + pitch.tuning.clearance / 2; }

/// x [m] of the line on which the keeper stands.
inline double keeperLine(const Pitch& pitch) { return keeperDepth(pitch) - pitch.half_length; }

/// y [m] at which the free ball crosses the line at x = `line` [m] within the forecast; empty if it does
/// not.
std::optional<double> crossing(const Picture& picture, double line);

/// y [m] at which a ball crosses the keeper's line, in front of the mouth or less than a robot beside it;
/// empty if it does not.
std::optional<double> shotAtKeeper(const Picture& picture);

/// `y` [m] limited to places of a keeper within the mouth.
double withinMouth(const Pitch& pitch, double y);

/// y [m] within the mouth of a keeper that awaits no shot.
double readyPlace(const Picture& picture);

/// y [m] of a keeper that awaits a ball which opponents push: equal gaps to both posts would leave the far
/// one more time, so it stands nearer to the other.
double evenRestPlace(const Picture& picture);

/// Whether the ball rolls into the own goal or at a post within the forecast, however slowly.
bool shotComes(const Picture& picture);

/// Whether the ball rolls into the own goal and `robot`, which is near the goal, must save it.
bool mustSave(const Picture& picture, int robot);

/// Whether the ball lies or rolls along the own end wall, at the edge of the mouth or beside it, less than
/// `width` [m] beside the goal's centre.
bool ballAlongEndWall(const Picture& picture, double width);

/// Whether the keeper is at the end wall on the goal's side of the ball: the wall is behind it, so that no
/// ball passes there.
bool closesEndWall(const Picture& picture, const RobotState& self);

/// Drives along the line at `speed` [m/s]. A small turn toward the line corrects the distance from it.
Twist alongLine(const Pitch& pitch, const RobotState& self, double line, double speed);

/// The greatest speed [m/s] at which the robot can still stop `way` [m] ahead.
double stoppableSpeed(const Pitch& pitch, double way);

/// Drives to `y` [m] on the line with the body parallel to it.
Twist slideTo(const Picture& picture, const RobotState& self, double line, double y);

}  // namespace fulbito::libero
