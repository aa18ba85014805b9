#pragma once

#include <vector>

#include "navigation/interface/parameters.hpp"
#include "navigation/methods/reactive/nearness_motion.hpp"

namespace fulbito {

/// Parameters of the nearness diagram. The lengths are the paper's, scaled from its 22 cm robot to a 7.5 cm
/// one.
struct NearnessDiagramParams {
  int sectors = 180;          ///< n
  double range = 0.36;        ///< d_max [m] from the centre
  double security = 0.19;     ///< d_s [m] from the hull
  double gap_margin = 0.002;  ///< [m] added to half the robot's width to get R
  double margin = 0.01;       ///< [m] gap of the emergency rules
  double braking = 0.25;      ///< share of the wheel acceleration; larger shares are unsafe above 1 m/s
  WideRegionRule wide_region = WideRegionRule::kCorner;
};

/// Nearness diagram navigation (Minguez & Montano, T-RA 20(1), 2004; the reactive layer of Kim et al. 2006).
/// In each tick it takes the nearest point of obstacles and walls in every sector, classifies the situation
/// and returns one direction and a speed. It has no memory.
///
/// The direction becomes a constant heading field and the speed a cap, so that the shared follower drives the
/// robot and comparisons rate methods, not controllers. The paper's own law is v_max k cos, omega_max k sin.
/// The published method has no model of inertia. As an addition to it, the cap also lets the robot stop in
/// front of anything straight ahead.
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
  std::vector<SectorHit> seen_;     ///< nearest points in all sectors
  std::vector<SectorHit> diagram_;  ///< those of them within d_max
  NearnessMotion motion_;
  double direction_ = 0.0;  ///< [rad] in the world frame
};

}  // namespace fulbito
