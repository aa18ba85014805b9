#pragma once

#include "navigation/methods/fields/goal_field.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// The tangent rule of the textbook's fields: toward the goal, and where the nearest circle about an obstacle
/// lies in the way, along its tangent. Overlapping circles are passed together, on one side that is kept. The
/// strong baseline among the fields.
class TangentField final : public Navigator, public HeadingField {
 public:
  struct Params {
    double offset = 0.087;         ///< R_o [m] radius of the circle about a ball-sized obstacle's centre
    double range = 0.40;           ///< [m] farther obstacles do not act yet
    double hysteresis = 0.174533;  ///< [rad] by which the other side must be better to change to it
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
