#pragma once

#include <array>

#include <box2d/b2_math.h>

#include "fulbito/world.hpp"

class b2Body;
class b2RevoluteJoint;
class b2World;

namespace fulbito {

/// A rod on two joints at the centres of two robots. It has mass and inertia but no outline.
class CarriedRod {
 public:
  CarriedRod(b2World& world, const RodPlacement& rod, b2Body& first, b2Body& second);

  b2Body& body() const { return *body_; }
  void startTick() { impulses_ = {}; }
  /// Adds the joints' impulses of the engine's last step.
  void addImpulses();
  /// Its state after a tick of `period` [s].
  RodState state(double period) const;

 private:
  b2Body* body_;
  std::array<b2RevoluteJoint*, 2> joints_;
  std::array<Vec2, 2> impulses_{};  // [kg m/s] on the rod in this tick
};

}  // namespace fulbito
