#pragma once

#include <array>
#include <vector>

#include "engine/sim/steps/place.hpp"

namespace fulbito {

/// Tries to prove that no body meets a wall or a disc within a step. Then the engine need not search for such
/// contacts ("continuous"): it would find none. A wrong no only costs time; a yes is always right.
class Clearance {
 public:
  /// @param bullets  the engine looks for contacts of discs with boxes too, not only for those of walls
  explicit Clearance(bool bullets) : bullets_(bullets) {}

  /// Adds a moving box. Add all boxes before the first disc.
  void addBox(const b2Body* body, float half_length, float half_width);
  void addDisc(const b2Body* body, float radius);
  /// Adds a wall by its corners, of which the first and the last bound its face [Box2D units].
  void addWall(const std::array<b2Vec2, 4>& corners);
  /// Sets the half sizes of the field without its goals, and the length that corner walls cut off along both
  /// sides [Box2D units].
  void setField(float half_length, float half_width, float corner);

  /// Remembers where all bodies are. Call before the engine's step of `dt` [s].
  void remember(float dt);
  /// Before the engine's step: whether no body meets a wall or disc if it keeps its velocity. True only if
  /// that is certain. Valid if no bodies touch, as contacts change velocities.
  bool isKeptFreely();
  /// The same within the step, when the engine has solved the contacts of its start and moved the bodies that
  /// have any. The other bodies may not have moved yet.
  bool isKeptSolved();

 private:
  struct Mover : Outline {
    Place from{};
    Place to{};
    b2Vec2 drift{};      // displacement if nothing stops it
    float spin = 0.0f;   // [rad] turn if nothing stops it
    float angle = 0.0f;  // [rad] heading before the step
    float turn = 0.0f;   // [rad] absolute turn in the step
  };
  struct Edge {
    b2Vec2 point;
    b2Vec2 out;     // unit, out of the wall
    float allowed;  // overlap along `out` that the engine does not notice yet
  };
  using Wall = std::array<Edge, 4>;

  static float extent(const Mover& mover, const Place& at, b2Vec2 axis);
  static float bulge(const Mover& mover);
  static float mostWay(const Mover& mover);
  static void goFreely(Mover& mover);
  static void follow(Mover& mover);
  static bool keepsOff(const Mover& mover, const Wall& wall);
  static bool keepApart(const Mover& box, const Mover& disc);
  bool isInside(const Mover& mover, const Place& at, float slack) const;
  bool keepsOffWalls(const Mover& mover) const;
  bool keepsOffOthers(std::size_t disc) const;
  bool isKept() const;

  bool bullets_;
  b2Vec2 field_{0.0f, 0.0f};  // half sizes
  float diagonal_ = 0.0f;     // from the middle to the wall that cuts a corner off
  b2Vec2 open_{0.0f, 0.0f};   // half sizes of a rectangle without walls
  std::size_t boxes_ = 0;
  std::vector<Mover> movers_;  // boxes, then discs
  std::vector<Wall> walls_;
};

}  // namespace fulbito
