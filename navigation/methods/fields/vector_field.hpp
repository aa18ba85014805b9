#pragma once

#include <vector>

#include "navigation/methods/fields/goal_field.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// The repulsive-ring vector field of Jung & Lee (2015), Figs 1 and 2 (a reconstruction): inside a ring
/// about the nearest obstacle the field points straight away from it, and over the ring's width it goes over,
/// by angle, to the goal field. It shows the weaknesses that the paper lists: abrupt turns, a goal near an
/// obstacle that is never reached, and repulsion after passing; they are the method's and stay. The defaults
/// are those that are the safest and fastest on training layouts under both followers (docs/navigators.md):
/// no radial part, a wide transition. The ring of the figures is offset 10 cm, width 5 cm.
class VectorField final : public Navigator, public HeadingField {
 public:
  struct Params {
    double offset = 0.0;  ///< R_o [m] centre distance up to which the field is radial
    double width = 0.22;  ///< M [m] over which it goes over to the goal field
    GoalFieldParams goal_field{.kind = GoalFieldKind::kPosture};
  };

  explicit VectorField(Params params) : params_(params), goal_(params.goal_field) {}
  void reset() override {}
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  Params params_;
  GoalField goal_;
  std::vector<Circle> rings_;  ///< radius: where the field stops to be radial
};

}  // namespace fulbito
