#pragma once

#include <vector>

#include "engine/core/models/sensor.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// The observation that a navigator gets: the readings of the trial's sensors, rolled forward through the
/// commands since then. Velocities have no noise.
class Sensing {
 public:
  Sensing(const TrialConfig& config);

  /// Processes the true state after a tick.
  void observe(const WorldState& world);
  /// Stores the command of the next tick.
  void commanded(WheelSpeeds command);
  /// The present estimate of the robot.
  const RobotState& robot() const { return robot_; }
  /// The present estimate of the obstacles.
  const std::vector<DiscObstacle>& obstacles() const { return discs_; }

 private:
  struct Sight {
    RobotState robot;
    std::vector<std::vector<DiscObstacle>> obstacles;  ///< each as a list of discs that cover it
  };
  void look(const WorldState& world);

  const TrialConfig& config_;
  const double dt_;
  Sensor sensor_;
  Sight last_;  ///< last sighting of each body, at different times
  DelayedPictures<Sight> sights_;
  std::vector<WheelSpeeds> commands_;  ///< ring of the last `latency_ticks` commands
  std::size_t given_ = 0;
  RobotState robot_;
  std::vector<DiscObstacle> discs_;
};

}  // namespace fulbito
