#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {

/// Skills of the library as choices of an agent (docs/skills.md).
enum class Skill : std::uint8_t {
  kStay,       ///< stop
  kStrike,     ///< drive behind the ball and through it toward the widest gap of the opponents' goal
  kClear,      ///< the same toward a side wall upfield
  kIntercept,  ///< drive to the earliest meeting with the ball
  kReceive,    ///< follow the ball on its line at its speed
  kKeep,       ///< guard the own goal on a line in front of it
  kShadow,     ///< stand between the ball and the own goal
  kRebound,    ///< stand where rebounds from the opponents' goal come
  kSpin,       ///< spin so that the ball beside the robot leaves toward the opponents' goal
  kBackOff,    ///< drive backward
};

/// Names of the skills in order.
std::vector<std::string> skillNames();

/// The skills of one robot, with what they remember from tick to tick.
class RobotSkills {
 public:
  /// A new match begins.
  void begin(const MatchInfo& info);
  /// The command of a skill in this tick.
  RobotCommand play(Skill skill, const Observation& seen, std::size_t robot);

 private:
  RobotCommand strikeToward(Vec2 target, const Observation& seen, const RobotState& robot);
  RobotCommand keep(const RobotState& robot);
  Vec2 shotTarget(const Observation& seen) const;

  MatchInfo info_;
  BallCourse course_;
  RobotPace pace_;
  BallPrediction ball_;
  bool round_ = false;     ///< the robot drives round the ball
  bool lined_up_ = false;  ///< it drives straight through it
};

}  // namespace fulbito
