#pragma once

#include <deque>
#include <vector>

#include "engine/core/math/random.hpp"
#include "experiments/trials/trial.hpp"

namespace fulbito {

/// The observation that a navigator gets: delayed, noisy, and rolled forward through the commands given
/// meanwhile.
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
    std::vector<DiscObstacle> discs;
  };
  Sight look(const WorldState& world);

  const TrialConfig& config_;
  const double dt_;
  Rng noise_;
  std::vector<Sight> sights_;          ///< ring of the last latency + 1 observations
  std::vector<WheelSpeeds> commands_;  ///< ring of the last latency commands
  std::size_t seen_ = 0;
  std::size_t given_ = 0;
  RobotState robot_;
  std::vector<DiscObstacle> discs_;
};

}  // namespace fulbito
