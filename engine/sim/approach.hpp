// Private header of engine/sim: not installed.
#pragma once

#include <cstddef>
#include <vector>

#include <box2d/b2_math.h>

class b2Body;

namespace fulbito {

/// Plans a physics step so that bodies that meet in it come into each other no deeper than allowed. Box2D
/// notices most contacts only after they have begun, at the end of a step, so a step in which a pair would
/// meet too deep is split. Walls, and a ball that is a bullet, it notices in time ("continuous"): that costs
/// as much as solving the step, and is left out where nothing can come deep. It is not enough in a crowd:
/// such a contact stops a body in the middle of the step, and those who follow close behind drive on.
class Approach {
 public:
  /// What to ask of the engine.
  struct Plan {
    float share = 1.0f;      ///< of the time asked about: (0, 1]
    bool continuous = true;  ///< whether the engine looks for contacts within the step
  };

  /// @param depth  [Box2D units] allowed; <= 0: steps are never split
  /// @param bullets  the engine notices the discs' contacts in time
  Approach(float depth, bool bullets) : depth_(depth), bullets_(bullets), always_continuous_(!bullets) {}

  /// A box that moves. All boxes are added before the first disc.
  void addBox(const b2Body* body, float half_length, float half_width);
  void addDisc(const b2Body* body, float radius);
  /// The inner face of a wall, from one corner of the field to the next, counter-clockwise [Box2D units].
  void addWall(b2Vec2 from, b2Vec2 to);
  /// Half of a rectangle about the middle in which there is no wall [Box2D units].
  void setOpen(float half_length, float half_width) { open_ = {half_length, half_width}; }
  /// There are bodies that are not added here: every step looks for contacts within it.
  void setAlwaysContinuous() { always_continuous_ = true; }

  /// How to do a step of `dt` [s], or the first part of it, as all move now.
  Plan plan(float dt);

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
    Place now{};
    b2Vec2 change{};       // of its middle in the step, where nothing stops it
    float angle = 0.0f;    // that it turns meanwhile
    float travel = 0.0f;   // length of the change
    float turn = 0.0f;     // way of its outline's farthest point about its middle
    bool crowded = false;  // another box is near
  };
  struct Face {
    b2Vec2 middle;
    b2Vec2 out;  // unit, into the wall
    float half;  // of its length
  };
  struct Meeting {
    float before;  // gap now; negative: depth
    float moved;   // the most by which it can change in the step
  };
  static Place placeAfter(const Mover& mover, float share);
  static bool inReach(const Mover& a, const Mover& b);
  static float gap(const Mover& box, const Place& at_box, const Mover& other, const Place& at_other);
  void look(float dt);
  bool meet(const Mover& box, const Mover& other, Meeting& meeting) const;
  float allowed(float before) const;
  float shareOf(float before, float after) const;
  float shareOfPair(const Mover& box, const Mover& other, const Meeting& meeting) const;
  bool isByWall(const Mover& mover) const;
  float shareAtWalls(const Mover& mover) const;
  void planBoxes(Plan& plan);
  void planDisc(Mover& disc, Plan& plan);
  void planDiscs(Plan& plan);
  void planWalls(Plan& plan) const;

  float depth_;
  bool bullets_;
  bool always_continuous_;
  b2Vec2 open_{0.0f, 0.0f};
  std::size_t boxes_ = 0;
  std::vector<Mover> movers_;  // boxes, then discs
  std::vector<Face> faces_;
};

}  // namespace fulbito
