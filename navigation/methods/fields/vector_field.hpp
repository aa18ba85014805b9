#pragma once

#include <vector>

#include "navigation/methods/fields/goal_field.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// The repulsive-ring vector field of Jung & Lee (2015), Figs 1 and 2 (a reconstruction). Inside a ring about
/// the nearest obstacle the field points straight away from it. Over the ring's width its angle changes to
/// that of the goal field. The field has the weaknesses that the paper lists: abrupt turns, goals near an
/// obstacle that it never reaches, and repulsion after passing. The defaults were the safest and fastest on
/// training layouts under both followers (docs/navigators.md): no radial part and a wide transition. The ring
/// of the figures has an offset of 10 cm and a width of 5 cm.
class VectorField final : public Navigator, public HeadingField {
 public:
  struct Params {
    double offset = 0.0;  ///< R_o [m] distance from the obstacle's centre up to which the field is radial
    double width = 0.22;  ///< M [m] width of the transition to the goal field
    GoalFieldParams goal_field{.kind = GoalFieldKind::kPosture};
  };

  explicit VectorField(Params params) : params_(params), goal_(params.goal_field) {}
  void reset() override {}
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  Params params_;
  GoalField goal_;
  std::vector<Circle> rings_;  ///< the radius is where the radial field ends
};

}  // namespace fulbito
