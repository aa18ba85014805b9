#pragma once

#include <array>

#include "engine/core/models/sensor.hpp"
#include "fulbito/match.hpp"
#include "fulbito/values.hpp"

namespace fulbito {

/// All moving things as one team sees them, in the world's frame.
struct Sight {
  std::array<RobotState, 2 * kMaxTeamSize> robots;  ///< in the order of the world's
  BallState ball;
};

/// What one team sees through an imperfect camera: late, noisy, with gaps. Velocities of what is seen with
/// noise are not the true ones, but tracked from the noisy positions by a g-h filter, as a team would.
class Vision {
 public:
  Vision(const VisionModel& model, std::uint64_t seed, TeamId seat, double dt);

  /// A new play begins: during the stoppage the teams have seen where all stand.
  void reset(const WorldState& world);
  /// Takes the picture of this tick.
  /// @return the picture that arrives now, `latency_ticks` old
  const Sight& see(const WorldState& world);

 private:
  /// One coordinate that is tracked: where the filter believes it, and how fast it moves.
  struct Track {
    double value = 0.0;
    double rate = 0.0;
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
  Sight last_;  ///< as seen last, each body at its own time
  DelayedPictures<Sight> pictures_;
};

}  // namespace fulbito
