#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fulbito/match.hpp"

namespace fulbito {

/// What an agent's action is.
enum class ActionForm : std::uint8_t {
  kWheels,  ///< 2 numbers: left and right wheel speed over the robot's top wheel speed
  kTwist,   ///< 2 numbers: forward speed over the top speed, yaw rate over that of a spin in place
  kGoTo,    ///< 3 numbers: x over half the field's length, y over half its width, heading on arrival over pi
  kSkill,   ///< 1 number: a skill of the library, see `Skill`
  kCompat,  ///< 2 numbers: the wheels as rSoccer's VSS-v0 has them
};

/// What an agent sees.
enum class ObservationForm : std::uint8_t {
  kAbsolute,    ///< places in the team's frame
  kEgocentric,  ///< places as seen from the robot
  kCompat,      ///< 40 numbers as in rSoccer's VSS-v0
};

/// Which terms the reward has.
enum class RewardForm : std::uint8_t {
  kShaped,  ///< goal, ball, move, energy, foul
  kCompat,  ///< goal_score, move, ball_grad, energy: as in rSoccer's VSS-v0
};

/// Where episodes begin.
enum class StartForm : std::uint8_t {
  kKickOff,  ///< with the first kick-off of a match
  kRandom,   ///< all bodies at rest at random places
};

/// Factors of the terms of RewardForm::kShaped. A factor of 0 switches a term off.
struct RewardWeights {
  double goal = 10.0;    ///< per goal: positive for the team's own, negative for the opponents'
  double ball = 2.0;     ///< per gain of the ball's potential, which is 1 from goal to goal
  double move = 0.2;     ///< per metre that the robot and the ball come closer
  double energy = 0.01;  ///< per second with both wheels at top speed: a cost
  double foul = 0.0;     ///< per foul called against the team: a cost
};

/// A number of the models that each episode draws anew.
struct ModelRange {
  std::string key;    ///< such as "robot.mass" or "ball.friction": a key of robot files
  double low = 0.0;   ///< in the unit of the key
  double high = 0.0;  ///< in the unit of the key
};

/// The configuration of an environment that plays matches.
struct MatchTask {
  /// The match: its teams drive all robots but the agents. Seed and start are each episode's own.
  MatchConfig match;
  PerTeam<std::array<bool, kMaxTeamSize>> agents{};  ///< robots that the caller drives, by team and number
  ActionForm actions = ActionForm::kWheels;
  NavigatorChoice navigator;  ///< plans the ways of kGoTo and kSkill
  int frame_skip = 1;         ///< ticks per step, 1 ... 1000
  ObservationForm observations = ObservationForm::kAbsolute;
  int stack = 1;  ///< observations of the last steps in one, the newest first, 1 ... 100
  RewardForm reward = RewardForm::kShaped;
  RewardWeights weights;
  StartForm start = StartForm::kKickOff;
  bool ends_at_goal = true;        ///< a goal terminates the episode
  double seconds = 0.0;            ///< [s] of the match after which an episode is truncated; 0: no limit
  std::vector<ModelRange> ranges;  ///< models of robots and ball that each episode draws
};

/// Checks the task. Errors: kUsage naming what is out of its range; as `Match::create`.
Result<void> checkTask(const MatchTask& task);

/// The agents in order: blue before yellow, by number.
std::vector<RobotId> agentsOf(const MatchTask& task);

}  // namespace fulbito
