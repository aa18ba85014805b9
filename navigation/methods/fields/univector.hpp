#pragma once

#include <vector>

#include "navigation/methods/fields/goal_field.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// Univector field navigation (Kim, Kim & Kwon 2001; Lim et al., IFAC 2008): a move-to-goal field composed
/// with the field away from the nearest obstacle, which a Gaussian of the distance weighs and which is
/// shifted by the relative velocity ("virtual obstacle"). The two directions are blended along the shorter
/// arc. As in the sources the field is discontinuous where the nearest obstacle changes, has a saddle in
/// front of each obstacle and may never reach a goal near one; three switches, off by default, mend that.
class Univector final : public Navigator, public HeadingField {
 public:
  struct Params {
    double d_min = 0.09;    ///< [m] distance to the obstacle up to which only it counts
    double delta = 0.0457;  ///< [m] width of the Gaussian beyond
    double k0 = 0.12;       ///< K_0 [s] shift of the virtual obstacle per relative velocity
    GoalFieldParams goal_field{};
    bool hold_side = false;      ///< in front of an obstacle keep the turning side for 0.3 s
    bool shrink = false;         ///< narrow the Gaussian of obstacles near the goal
    bool ignore_beyond = false;  ///< obstacles farther than the goal do not act
  };

  explicit Univector(Params params) : params_(params), goal_(params.goal_field) {}
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  struct Source {
    Vec2 position;
    Vec2 shift;  ///< K_0 times the relative velocity
    double extra = 0.0;
    double delta = 0.0;
  };
  /// What acts at a point.
  struct Influence {
    const Source* source = nullptr;
    double distance = 0.0;  ///< [m] to the virtual obstacle, less its extra size
    Vec2 away;
  };
  Influence nearest(Vec2 p) const;
  void holdSide(const NavigationScene& scene);

  Params params_;
  GoalField goal_;
  std::vector<Source> sources_;
  int held_ = 0;  ///< +1 turn left, -1 right at the saddle, 0 nothing held
  Tick held_since_ = 0;
};

}  // namespace fulbito
