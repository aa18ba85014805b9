#pragma once

#include "match/drills/trial_run.hpp"

namespace fulbito {

/// How far a trial is, by the true world. Rewards are differences of these, so that their sum over an episode
/// does not depend on the way.
struct DrillProgressNow {
  double ball = 0.0;      ///< of the ball toward a success, as a share: 1 is there
  double approach = 0.0;  ///< [m] minus the robot's distance from where it is needed
  double align = 0.0;     ///< minus the error of the task's heading, as a share of a half turn
};

/// @param robot  number of the agent's robot
DrillProgressNow drillProgress(const DrillTrialRun& trial, int robot, const RobotPreset& preset);

}  // namespace fulbito
