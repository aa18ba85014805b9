#pragma once

#include "navigation/interface/parameters.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// Direction [rad] of the limit-cycle equation in dimensionless form (docs/papers.md), at `offset` [m] from
/// the centre of a stable circular orbit:
///   X' = s Y + mu X (1 - (X^2 + Y^2) / r^2),  Y' = -s X + mu Y (1 - (X^2 + Y^2) / r^2)
/// where s is +1 for clockwise (the robot passes on the left of the circle) and -1 for counter-clockwise.
double orbitHeading(Vec2 offset, double radius, double mu, bool clockwise);

/// Limit-cycle navigation (Kim & Kim, RAS 42, 2003): straight toward the goal, and on a stable orbit about
/// the nearest obstacle that blocks the straight line. Overlapping orbits share one direction, which is kept,
/// but reversed where the orbit would leave the field. For an arrival heading, an orbit that touches the line
/// of arrival at the goal leads the robot in.
class LimitCycle final : public Navigator, public HeadingField {
 public:
  struct Params {
    double margin = 0.015;         ///< [m] added to the bodies' radii for an orbit
    double mu = 2.0;               ///< larger: the robot turns onto the orbit later
    double hysteresis = 0.174533;  ///< [rad] advantage that the other side needs for a change
    double posture_radius = 0.10;  ///< [m] of the orbit that leads to the arrival heading
  };

  explicit LimitCycle(Params params) : params_(params) {}
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  void decidePosture(const NavigationScene& scene);
  bool postureActs(Vec2 p) const;

  Params params_;
  ClusteredCircles circles_;
  Vec2 goal_;
  Circle posture_;                                      ///< radius 0 without an arrival heading
  PassingSide posture_side_ = PassingSide::kUndecided;  ///< side of the line of arrival
};

}  // namespace fulbito
