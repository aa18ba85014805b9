#pragma once

#include <vector>

#include <box2d/b2_math.h>

class b2Body;

namespace fulbito {

/// Ensures that contacts do no work. A solver with few iterations can add energy to bodies that press on each
/// other. This class takes back the excess part of the contact impulses. All impulses shrink by the same
/// factor, so momentum is conserved.
class ContactWork {
 public:
  void add(b2Body* body) { bodies_.push_back({body, {}, 0.0f}); }
  /// Call before the engine's step.
  void remember();
  /// Call after the step. If the energy has grown, sets all velocities to the mix of before and after that
  /// has the energy of before.
  void takeBack();

 private:
  struct Moving {
    b2Body* body;
    b2Vec2 velocity;  // before the step
    float spin;       // [rad/s] the same
  };
  std::vector<Moving> bodies_;
};

}  // namespace fulbito
