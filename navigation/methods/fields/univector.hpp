#pragma once

#include <vector>

#include "navigation/methods/fields/goal_field.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// Univector field navigation (Kim, Kim & Kwon 2001; Lim et al., IFAC 2008). It blends a move-to-goal field
/// with the field away from the nearest obstacle, weighted by a Gaussian of the distance and shifted by the
/// relative velocity ("virtual obstacle"). The directions are blended along the shorter arc. As in the
/// sources, the field is discontinuous where the nearest obstacle changes, has a saddle in front of each
/// obstacle and may never reach a goal near one. Three switches, off by default, remove these flaws.
class Univector final : public Navigator, public HeadingField {
 public:
  struct Params {
    double d_min = 0.09;    ///< [m] only the obstacle counts up to this distance
    double delta = 0.0457;  ///< [m] width of the Gaussian beyond `d_min`
    double k0 = 0.12;       ///< K_0 [s] shift of the virtual obstacle per relative velocity
    GoalFieldParams goal_field{};
    bool hold_side = false;      ///< keep the side of a turn in front of an obstacle for 0.3 s
    bool shrink = false;         ///< narrow the Gaussian of obstacles near the goal
    bool ignore_beyond = false;  ///< ignore obstacles farther away than the goal
  };

  explicit Univector(Params params) : params_(params), goal_(params.goal_field) {}
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  struct Source {
    Vec2 position;
    Vec2 shift;  ///< [m] K_0 times the relative velocity
    double extra = 0.0;
    double delta = 0.0;
  };
  /// The obstacle that acts at a point.
  struct Influence {
    const Source* source = nullptr;
    double distance = 0.0;  ///< [m] to the virtual obstacle, less the extra size of the bodies
    Vec2 away;
  };
  Influence nearest(Vec2 p) const;
  void holdSide(const NavigationScene& scene);

  Params params_;
  GoalField goal_;
  std::vector<Source> sources_;
  int held_ = 0;  ///< +1: turn left at the saddle, -1: right, 0: not decided
  Tick held_since_ = 0;
};

}  // namespace fulbito
