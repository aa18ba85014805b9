#pragma once

#include <string>

#include "engine/core/base/result.hpp"

namespace fulbito {

/// Time steps and accuracy of the physics. Navigators and teams act once per control tick, which may consist
/// of several physics steps.
struct PhysicsProfile {
  std::string name = "standard";
  int control_rate = 60;               ///< [Hz] 10 ... 1000
  int substeps = 2;                    ///< physics steps per control tick, 1 ... 64
  int velocity_iterations = 12;        ///< 1 ... 50; with 8, squeezed chains gain energy more often
  int position_iterations = 10;        ///< 1 ... 50; the engine stops early once all errors are small
  bool bullet_ball = true;             ///< continuous collision of the ball against moving bodies too
  double contact_depth = 0.0007;       ///< [m] steps are split so that bodies overlap no deeper; 0: never
  double max_ball_speed = 10.0;        ///< [m/s] up to this speed the ball does not tunnel
  double restitution_threshold = 0.1;  ///< [m/s] impacts slower than this do not bounce
  double wheel_command_step = 0.01;    ///< [rad/s] wheel commands are rounded to multiples of this before use

  double controlPeriod() const { return 1.0 / control_rate; }                                 ///< [s]
  double stepPeriod() const { return 1.0 / (static_cast<double>(control_rate) * substeps); }  ///< [s]
};

/// Checks ranges; the error names the key.
Result<void> validate(const PhysicsProfile& physics);

}  // namespace fulbito
