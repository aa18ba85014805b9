// Private header of engine/sim: not installed.
#pragma once

#include <cstddef>
#include <vector>

#include <box2d/b2_math.h>

class b2Body;

namespace fulbito {

/// Finds where a physics step must be split so that bodies that meet in it come into each other no deeper
/// than allowed. Box2D notices most contacts only after they have begun, at the end of a step. What
/// it notices in time - walls, and a ball that is a bullet - counts in a crowd only: such a contact stops a
/// body in the middle of the step, and those who follow close behind drive on.
class Approach {
 public:
  /// @param depth  [Box2D units] allowed; <= 0: steps are never split
  /// @param bullets  the engine notices the discs' contacts in time
  Approach(float depth, bool bullets) : depth_(depth), bullets_(bullets) {}

  /// A box that moves. All boxes are added before the first disc.
  void addBox(const b2Body* body, float half_length, float half_width);
  void addDisc(const b2Body* body, float radius);
  /// The inner face of a wall, from one corner of the field to the next, counter-clockwise [Box2D units].
  void addWall(b2Vec2 from, b2Vec2 to);
  /// Half of a rectangle about the middle in which there is no wall [Box2D units].
  void setOpen(float half_length, float half_width) { open_ = {half_length, half_width}; }

  /// How much of a step of `dt` [s] may be done at once, as all move now: (0, 1].
  float share(float dt);

 private:
  struct Place {
    b2Vec2 middle;
    b2Vec2 ahead;  // unit
  };
  struct Mover {
    const b2Body* body;
    float half_length;
    float half_width;
    float radius;  // around that: a disc is a point with a radius
    float reach;   // of its outline from its middle
    Place now;
    Place then;    // at the step's end, where nothing stops it
    float turn;    // way of its outline's farthest point about its middle
    bool crowded;  // another box is near
  };
  struct Face {
    b2Vec2 middle;
    b2Vec2 out;  // unit, into the wall
    float half;  // of its length
  };
  static bool mayMeet(const Mover& a, const Mover& b);
  static float extentAlong(const Mover& mover, const Place& place, b2Vec2 axis);
  static float gap(const Mover& a, const Place& at_a, const Mover& b, const Place& at_b);
  void look(float dt);
  bool isQuiet(const Mover& a, const Mover& b) const;
  float shareOf(float before, float after) const;
  float shareOfPair(const Mover& a, const Mover& b) const;
  float shareAtWalls(const Mover& mover) const;

  float depth_;
  bool bullets_;
  b2Vec2 open_{0.0f, 0.0f};
  std::size_t boxes_ = 0;
  std::vector<Mover> movers_;  // boxes, then discs
  std::vector<Face> faces_;
};

}  // namespace fulbito
