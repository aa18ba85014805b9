#pragma once

#include <vector>

#include "navigation/interface/parameters.hpp"
#include "navigation/methods/reactive/nearness_motion.hpp"

namespace fulbito {

/// Settings of the nearness diagram. Lengths are the paper's, scaled from its 22 cm robot to a 7.5 cm one.
struct NearnessDiagramParams {
  int sectors = 180;          ///< n
  double range = 0.36;        ///< d_max [m] from the centre
  double security = 0.19;     ///< d_s [m] from the hull
  double gap_margin = 0.002;  ///< [m] added to half the robot's width for R
  double margin = 0.01;       ///< [m] room of the emergency rules
  double braking = 0.25;      ///< share of the wheel acceleration; more is unsafe above 1 m/s
  WideRegionRule wide_region = WideRegionRule::kCorner;
};

/// Nearness diagram navigation (Minguez & Montano, T-RA 20(1), 2004; the reactive layer of Kim et al. 2006).
/// Each tick it sees obstacles and walls as the nearest point in every sector, names the situation and gives
/// one direction and a speed; it remembers nothing.
///
/// The direction comes as a constant heading field and the speed as a cap, so that the shared follower drives
/// it and methods are compared, not controllers (the driver's own law is v_max k cos, omega_max k sin). As
/// the published method knows no inertia, the cap also lets the robot stop before what lies straight ahead:
/// our addition.
class NearnessDiagram final : public Navigator, public HeadingField {
 public:
  using Params = NearnessDiagramParams;
  explicit NearnessDiagram(Params params = {});
  void reset() override {}
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2) const override { return direction_; }
  /// The last decision.
  const NearnessMotion& motion() const { return motion_; }

 private:
  double brakingSpeed(const NavigationScene& scene) const;

  Params params_;
  SectorCircle circle_;
  std::vector<SectorHit> seen_;     ///< all that the sectors meet
  std::vector<SectorHit> diagram_;  ///< of that, what lies within d_max
  NearnessMotion motion_;
  double direction_ = 0.0;  ///< [rad] world frame
};

}  // namespace fulbito
