#pragma once

#include <array>

#include "engine/core/models/drive_law.hpp"

namespace fulbito {

/// A robot that pitches on the sliding supports before and behind its wheels. Hard braking loads the front
/// support, whose friction brakes more, until the wheels leave the floor and neither brake nor steer. The
/// model has the height of the centre of mass, the pitch and the load of each contact with the floor, which
/// is a stiff spring with a damper. For a level robot, `DriveLaw` alone gives the same motion.
class Tilt {
 public:
  /// Change of the body's motion, and the grip that the tyres keep across.
  struct Change {
    double forward = 0.0;       ///< [m/s]
    double turn = 0.0;          ///< [m/s] of half the difference of the rims' speeds
    double lateral_grip = 0.0;  ///< share of the grip of a level robot
  };

  /// @param dt  [s] one physics step
  Tilt(const RobotModel& robot, double dt);

  /// Whether the robot has supports and is tilted, or begins to be.
  bool isOff(double forward, RimSpeeds pulls) const {
    return mass_height_ > 0.0 && (tilted_ || brakes(forward, pulls));
  }
  /// One physics step of a robot for which `isOff` holds.
  /// @param ground  the rims' speed over the ground if the robot were level [m/s]
  /// @param target  their wanted speed [m/s]
  Change step(RimSpeeds ground, RimSpeeds target);
  /// Speeds of the rims themselves [m/s], which spin freely once the wheels are off the floor.
  RimSpeeds rims() const { return rims_; }
  bool isTilted() const { return tilted_; }

 private:
  static constexpr std::size_t kContacts = 5;   // front support, wheels, rear support, front and rear edge
  using Loads = std::array<double, kContacts>;  // [m/s^2]: forces over the mass

  struct Rates {
    double rise = 0.0;   // [m/s] upward speed of the centre of mass
    double pitch = 0.0;  // [rad/s], nose down
  };
  // The springs and dampers at one pose: sums over the contacts that touch.
  struct Footing {
    Loads springs{};
    std::array<bool, kContacts> touches{};
    // effective masses of rising and of pitching, and their coupling (`both`)
    double lift = 1.0, both = 0.0, swing = 0.0;
    double up = 0.0, down = 0.0;  // impulses of the springs
  };
  struct Standing {
    Loads loads{};
    Rates rates;
    double yield = 0.0;  // pitch rate per angular impulse over the mass [1/m^2]
  };
  struct Grips {
    double drive = 0.0;  // [m/s] largest pull of one wheel
    double slide = 0.0;  // [m/s] friction of supports and edges
  };
  struct Pulls {
    RimSpeeds wheels;     // [m/s] over half the mass
    double drag = 0.0;    // [m/s]
    double braked = 0.0;  // [m/s] change of the turn by edges that scrub
  };

  bool brakes(double forward, RimSpeeds pulls) const;
  Footing footing() const;
  void change(Footing& footing, std::size_t contact, double sign) const;
  Standing stand(Footing footing, Rates rates) const;
  Pulls pull(RimSpeeds ground, RimSpeeds target, const Grips& grips, double yield) const;
  double spunUp(double& rim, double ground, double target, double pull, double play, double grip) const;
  void part(RimSpeeds& ground, RimSpeeds target, double& lateral);

  double dt_;  // [s] length of a part of a step
  int parts_;  // parts per step
  double motor_, drag_, grip_, turn_, edges_, scrub_, most_braking_;
  double mass_height_;                   // [m]
  double inertia_;                       // [m^2] inertia of pitching over the mass
  double wheel_radius_;                  // [m]
  double rim_mass_;                      // share of the robot's mass
  double stiffness_, damping_;           // [1/s^2], [1/s] of one contact over the mass
  double friction_;                      // friction coefficient of the edges
  Loads damped_;                         // damping by each contact in a part, over the mass
  std::array<double, kContacts> place_;  // [m] place of each contact before the centre
  double clearance_;                     // [m] height of the edges
  bool tilted_ = false;
  double rise_ = 0.0;   // [m] height of the centre of mass above its place on rigid contacts
  double pitch_ = 0.0;  // [rad] nose down
  Rates rates_;
  RimSpeeds rims_;
};

}  // namespace fulbito
