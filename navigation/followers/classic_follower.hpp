#pragma once

#include "fulbito/navigation.hpp"
#include "navigation/followers/path_tracker.hpp"

namespace fulbito {

/// Gains of the classic univector control law.
struct ClassicParams {
  double yaw_gain = 10.0;   ///< K [sqrt(rad) / s]
  double turn_limit = 6.0;  ///< R_m [m/s^2], largest |v * omega|
};

/// The control law of univector fields (Y.-J. Kim et al. 2001, Lim et al. 2008): forward speed and yaw rate
/// from the heading error and the curvature of the field at the robot. It has no preview and is unsafe above
/// about 1 m/s. It serves as the reference from the papers.
class ClassicFollower final : public Follower {
 public:
  explicit ClassicFollower(ClassicParams params = {}) : params_(params) {}
  void reset() override { tracker_.reset(); }
  Twist follow(const Guidance& guidance, const NavigationScene& scene) override;

 private:
  double fieldHeading(const Guidance& guidance, Vec2 p);

  ClassicParams params_;
  PathTracker tracker_;
};

}  // namespace fulbito
