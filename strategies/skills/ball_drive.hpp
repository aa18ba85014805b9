#pragma once

#include <limits>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/strategy.hpp"

/// Driving round a ball and through it without a stop (docs/skills.md, Drive).
namespace fulbito {

/// The ball that a robot drives through, and how.
struct DriveGoal {
  Vec2 ball;                 ///< [m] its place at the meeting
  Vec2 direction{1.0, 0.0};  ///< unit vector of the wanted strike
  double bend = 1.0;   ///< [1] turn off the straight way per angle off the direction: above 1 it curves in
  double room = 0.03;  ///< [m] between ball and body on the way round
  double top_speed = std::numeric_limits<double>::infinity();  ///< [m/s]
};

/// One robot's drive: it holds the leading end. The way is a field of headings: toward the ball, turned aside
/// by `bend` times the angle off the wanted direction. The turn is at most that of the tangent to the circle
/// round the ball. The field follows Kim's N-posture and needs no navigator.
class BallDrive {
 public:
  /// The twist of this tick: as fast as the wheels and the grip in curves allow.
  Twist update(const MatchInfo& info, const RobotState& robot, const DriveGoal& goal);

 private:
  bool backward_ = false;
};

}  // namespace fulbito
