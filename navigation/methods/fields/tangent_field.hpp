#pragma once

#include "navigation/methods/fields/goal_field.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// The tangent rule of the textbook's fields: toward the goal, or along the tangent of the nearest circle
/// about an obstacle in the way. Overlapping circles are passed together, on one side, which is kept. It is
/// the strong baseline among the fields.
class TangentField final : public Navigator, public HeadingField {
 public:
  struct Params {
    double offset = 0.087;         ///< R_o [m] radius of the circle about a ball-sized obstacle's centre
    double range = 0.40;           ///< [m] obstacles farther away are ignored
    double hysteresis = 0.174533;  ///< [rad] advantage that the other side needs for a change
    GoalFieldParams goal_field{.kind = GoalFieldKind::kPosture};
  };

  explicit TangentField(Params params) : params_(params), goal_(params.goal_field) {}
  void reset() override { circles_.reset(); }
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  Params params_;
  GoalField goal_;
  ClusteredCircles circles_;
};

}  // namespace fulbito
