#pragma once

#include <optional>

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// A straight run of a robot that meets a rolling ball and sends it into the opponents' goal, or against a
/// post.
struct Volley {
  double time = 0.0;     ///< [s] from now until they meet
  Vec2 ball;             ///< [m] the ball's position then
  double heading = 0.0;  ///< [rad] of the run
  double spare = 0.0;    ///< [s] by which the robot would come too early if it started now
  double room = 0.0;     ///< [m] least gap between the ball on its way to the goal and posts and opponents
  Vec2 target;           ///< [m] where the ball crosses the goal line
};

/// The velocity [m/s] of a ball right after a hit, and as soon as it rolls: its old spin bends its way.
struct Hit {
  Vec2 leaves;
  Vec2 rolls;
};

/// The hit of a robot that drives along the unit vector `ahead` at `speed` [m/s] on a ball that rolls with
/// `rolling` [m/s]. The models of robot and ball give bounce, friction and spin.
Hit hitOf(const Pitch& pitch, Vec2 rolling, Vec2 ahead, double speed);

/// The least gap [m] of a run that is worth it. An opponent that just reaches the ball's way with its face
/// will hardly stop the ball, since it does not know that way before the hit. So only one whose middle gets
/// there in time counts. A free ball that is thrown but not shot is theirs as soon as ours, so there any gap
/// is enough. Where all opponents are in their area, nobody takes the ball from a robot that waits for a free
/// way.
double leastRoom(const Picture& picture);

/// The run that meets the ball at `time` [s] from now. Empty if the robot would come late, the ball runs away
/// from it, or it would miss both goal and posts. The gap to opponents is what their fastest way to the ball
/// leaves.
std::optional<Volley> volleyAt(const Picture& picture, int robot, double time);

/// The run with the widest gap. While a robot waits for the ball, opponents come nearer, so a wait costs the
/// way that they can drive in it. Empty if no run is worth it.
std::optional<Volley> bestVolley(const Picture& picture, int robot);

}  // namespace fulbito::libero
