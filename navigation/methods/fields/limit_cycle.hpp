#pragma once

#include "navigation/interface/parameters.hpp"
#include "navigation/obstacles/clustered_circles.hpp"

namespace fulbito {

/// Direction [rad] of the limit-cycle equation made free of units (docs/papers.md), at `offset` from the
/// centre of a stable circular orbit:
///   X' = s Y + mu X (1 - (X^2 + Y^2) / r^2),  Y' = -s X + mu Y (1 - (X^2 + Y^2) / r^2)
/// with s = +1 clockwise (the circle is passed on its left), -1 counter-clockwise.
double orbitHeading(Vec2 offset, double radius, double mu, bool clockwise);

/// Limit-cycle navigation (Kim & Kim, RAS 42, 2003): straight at the goal, and on a stable orbit about the
/// nearest obstacle that disturbs the straight line. Overlapping orbits have one direction, which is kept and
/// turned about where the orbit would leave the field. For a wanted arrival heading an orbit that touches the
/// line of arrival at the goal leads the robot in.
class LimitCycle final : public Navigator, public HeadingField {
 public:
  struct Params {
    double margin = 0.015;         ///< [m] that an orbit adds to the bodies' radii
    double mu = 2.0;               ///< larger: turns onto the orbit later
    double hysteresis = 0.174533;  ///< [rad] by which the other side must be better to change to it
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
  Circle posture_;                                      ///< radius 0: no arrival heading wanted
  PassingSide posture_side_ = PassingSide::kUndecided;  ///< of the line of arrival
};

}  // namespace fulbito
