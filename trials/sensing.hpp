#pragma once

#include <vector>

#include "engine/core/models/sensor.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// The observation that a navigator gets: what the trial's sensors show of the world, rolled forward through
/// the commands given meanwhile. Velocities are seen without noise.
class Sensing {
 public:
  Sensing(const TrialConfig& config);

  /// Takes in the true state after a tick.
  void observe(const WorldState& world);
  /// Takes in the command that the next tick will apply.
  void commanded(WheelSpeeds command);
  /// The robot as known now.
  const RobotState& robot() const { return robot_; }
  /// The obstacles as known now.
  const std::vector<DiscObstacle>& obstacles() const { return discs_; }

 private:
  struct Sight {
    RobotState robot;
    std::vector<std::vector<DiscObstacle>> obstacles;  ///< each as the discs that cover it
  };
  void look(const WorldState& world);

  const TrialConfig& config_;
  const double dt_;
  Sensor sensor_;
  Sight last_;  ///< as seen last, each body at its own time
  DelayedPictures<Sight> sights_;
  std::vector<WheelSpeeds> commands_;  ///< ring of the last latency commands
  std::size_t given_ = 0;
  RobotState robot_;
  std::vector<DiscObstacle> discs_;
};

}  // namespace fulbito
