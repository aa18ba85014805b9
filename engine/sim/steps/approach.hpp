#pragma once

#include <cstddef>
#include <vector>

#include "engine/sim/steps/place.hpp"

namespace fulbito {

/// Plans a physics step so that bodies that meet in it overlap no deeper than allowed. Box2D notices most
/// contacts only at the end of a step, so this class splits a step in which a pair would overlap too deep.
/// Box2D notices contacts of walls and of a bullet ball in time ("continuous"). That costs as much as solving
/// the step, so it is skipped if no pair can overlap deeply. In a crowd it is not enough: such a contact
/// stops a body in the middle of the step, and the bodies close behind drive on.
class Approach {
 public:
  /// Settings for the engine's next step.
  struct Plan {
    float share = 1.0f;      ///< part of the requested time to step: (0, 1]
    bool continuous = true;  ///< whether the engine searches for contacts within the step
  };

  /// @param depth  [Box2D units] allowed overlap; <= 0: never split steps
  /// @param bullets  the engine notices contacts of discs in time
  Approach(float depth, bool bullets) : depth_(depth), bullets_(bullets), always_continuous_(!bullets) {}

  /// Adds a moving box. Add all boxes before the first disc.
  void addBox(const b2Body* body, float half_length, float half_width);
  void addDisc(const b2Body* body, float radius);
  /// Adds the inner face of a wall between two corners of the field, counter-clockwise [Box2D units].
  void addWall(b2Vec2 from, b2Vec2 to);
  /// Sets the half sizes of a centred rectangle without walls [Box2D units].
  void setOpen(float half_length, float half_width) { open_ = {half_length, half_width}; }
  /// For worlds with bodies that are not added here: every step searches for contacts within it.
  void setAlwaysContinuous() { always_continuous_ = true; }

  /// Plans a step of `dt` [s], or its first part, from the present motion of all bodies.
  Plan plan(float dt);

 private:
  struct Mover : Outline {
    Place now{};
    b2Vec2 change{};       // displacement of its centre in the step, if nothing stops it
    float angle = 0.0f;    // [rad] turned in the step
    float travel = 0.0f;   // length of `change`
    float turn = 0.0f;     // arc of its outline's farthest point about its centre
    bool crowded = false;  // another box is near this box, or near one that a disc links to it
  };
  struct Face {
    b2Vec2 middle;
    b2Vec2 out;  // unit, into the wall
    float half;  // half of its length
  };
  struct Meeting {
    float before;  // gap now; negative: depth
    float moved;   // largest possible change of the gap in the step
  };
  struct Met {
    Mover* box;
    Meeting meeting;
  };
  static Place placeAfter(const Mover& mover, float share);
  static bool inReach(const Mover& a, const Mover& b);
  static float gap(const Mover& box, const Place& at_box, const Mover& other, const Place& at_other);
  void look(float dt);
  bool meet(const Mover& box, const Mover& other, Meeting& meeting) const;
  float allowed(float before) const;
  float shareOf(float before, float after) const;
  static float gapAfter(const Mover& box, const Mover& other, float share);
  float gapAsSolved(const Mover& box, const Mover& other, float before, float share) const;
  float shareOfPair(const Mover& box, const Mover& other, const Meeting& meeting) const;
  bool isByWall(const Mover& mover) const;
  float shareAtWalls(const Mover& mover) const;
  bool isNear(const Meeting& meeting) const;
  int meetBoxes(const Mover& disc);
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
  std::vector<Met> met_;       // boxes that the disc being planned can meet
  std::vector<Face> faces_;
};

}  // namespace fulbito
