#pragma once

#include <cstddef>
#include <vector>

#include <box2d/b2_math.h>

class b2Body;

namespace fulbito {

/// Bounds the speed of a ball that several bodies press on within one physics step. Two rigid edges that
/// close at u with an angle of 2 a between them drive a ball out at u / sin(a), which has no bound. Real
/// balls yield, and nearly parallel edges hold them by friction. So the ball leaves no faster than after two
/// successive impacts. The rest of its momentum goes to the bodies that hold it, as by friction.
class Squeeze {
 public:
  /// @param slow  [Box2D units per s] balls up to this speed are left as they are
  explicit Squeeze(float slow) : slow_(slow) {}

  void addBall(b2Body* ball) { balls_.push_back({ball}); }
  /// Call before the first part of each physics step.
  void startStep();
  /// Tells that a body pressed on a ball.
  /// @param other  number of the body
  /// @param surface_speed  [Box2D units per s] largest speed of the surface that touches
  void press(std::size_t ball, std::size_t other, float surface_speed, float restitution);
  /// Slows balls that are too fast. Call after each part of a physics step.
  /// @returns whether there is one
  bool limit();

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Ball {
    b2Body* body;
    std::size_t first = kNone;   // number of the body that pressed on it first in this step
    bool several = false;        // whether another body pressed on it too
    b2Vec2 before{};             // its velocity at the step's start, in Box2D units per s
    float surface_speed = 0.0f;  // largest of the step, in the same unit
    float restitution = 0.0f;    // restitution of the contact with that speed
  };
  static void slowTo(b2Body& ball, float speed);

  float slow_;
  std::vector<Ball> balls_;
};

}  // namespace fulbito
