// Private header of engine/sim: not installed.
#pragma once

#include <vector>

#include <box2d/b2_math.h>

class b2Body;

namespace fulbito {

/// Contacts do no work. A solver that stops after some iterations can leave bodies that press on each other
/// faster than they came; this takes back as much of the contacts' impulses as would add energy. The impulses
/// keep their proportions, so that momentum is kept too.
class ContactWork {
 public:
  void add(b2Body* body) { bodies_.push_back({body, {}, 0.0f}); }
  /// Before the engine's step.
  void remember();
  /// After it: gives the bodies a mean of their velocities before and after, with the energy before, where
  /// the energy grew.
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
