#pragma once

#include <array>

#include "engine/core/models/sensor.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/match.hpp"

namespace fulbito {

/// The moving bodies as one team sees them, in the world frame.
struct Sight {
  std::array<RobotState, 2 * kMaxTeamSize> robots;  ///< in the order of the world's robots
  BallState ball;                                   ///< the ball
};

/// One team's view through an imperfect camera: late, noisy, with gaps. With noise, a g-h filter computes the
/// velocities from the noisy positions, as a team would.
class Vision {
 public:
  Vision(const VisionModel& model, std::uint64_t seed, TeamId seat, double dt);

  /// To call when a new play begins: the teams know all poses from the stoppage.
  void reset(const WorldState& world);
  /// Takes the camera picture of this tick.
  /// @return the picture that arrives in this tick, `latency_ticks` old
  const Sight& see(const WorldState& world);

 private:
  /// The filter's estimate of one coordinate.
  struct Track {
    double value = 0.0;  ///< [m] or [rad]
    double rate = 0.0;   ///< [m/s] or [rad/s]
  };
  struct BodyTracks {
    Track x, y, heading;
    int gap = 0;  ///< ticks since the body was last seen
  };

  void look(const WorldState& world);
  bool seen(BodyTracks& tracks);
  void blur(BodyTracks& tracks, Vec2& position, Vec2& velocity);
  void blur(BodyTracks& tracks, double& heading, double& rate);

  double dt_;
  Sensor sensor_;
  std::array<BodyTracks, 2 * kMaxTeamSize + 1> tracks_;
  Sight last_;  ///< newest sight of each body, when it was last seen
  DelayedPictures<Sight> pictures_;
};

}  // namespace fulbito
