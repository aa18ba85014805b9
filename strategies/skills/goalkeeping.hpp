#pragma once

#include "strategies/prediction/foresight.hpp"
#include "strategies/skills/ball_drive.hpp"
#include "strategies/skills/wall_play.hpp"

namespace fulbito {

/// A keeper that stays on a line in front of its goal and rarely leaves it (docs/skills.md, Goalkeeping).
class LineKeeper {
 public:
  /// Limits of a keeper.
  struct Settings {
    double gap = 0.003;   ///< [m] between the goal line and the body on the keeper's line
    double lead = 0.15;   ///< [s] it leaves the line only if it is earlier at the ball by this time
    double leash = 0.25;  ///< [m] from the middle of the goal line: farthest ball that it leaves the line for
  };

  /// The keeper's command for robot `i`.
  RobotCommand update(const MatchInfo& info, const Foresight& foresight, const Observation& now,
                      std::size_t i, const Settings& settings);

 private:
  bool mayLeave(const MatchInfo& info, const Foresight& foresight, const Observation& now, std::size_t i,
                const Settings& settings) const;

  Twist slide(const MatchInfo& info, const RobotState& robot, Vec2 place);

  BallDrive drive_;
  SpinKick spin_;
  bool out_ = false;
  double stroke_ = 0.0;  ///< +1 or -1: the side of the stroke back onto the line; 0: none yet
};

}  // namespace fulbito
