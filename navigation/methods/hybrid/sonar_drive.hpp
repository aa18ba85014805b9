#pragma once

#include <array>
#include <optional>
#include <vector>

#include "navigation/methods/hybrid/strip_guide.hpp"

namespace fulbito {

/// Drives a robot that knows only what its range sensors hear: it maps what they prove (`ProvenMap`),
/// searches a way (`WaySearch`), goes through narrow places by a guide (`StripGuide`), and backs off where it
/// is stuck. Its sensors are those of `frontSonars`; others work as long as they look ahead.
class SonarDrive {
 public:
  void reset();
  /// The twist for this tick, before the robot's limits. `scene.ranges` is not empty.
  Twist drive(const NavigationScene& scene);

 private:
  void sense(const NavigationScene& scene);
  std::optional<Twist> backOff(const NavigationScene& scene);
  double roomAfter(Twist motion) const;
  std::optional<Twist> findEscape() const;
  Twist lookAbout(const NavigationScene& scene) const;
  Twist alongWay(const NavigationScene& scene);
  Twist safe(Twist wanted, double error) const;
  double ahead(const NavigationScene& scene, double widest) const;

  double size_ = 0.0;  ///< see `bodySize`; 0: nothing is made yet
  std::vector<RangeSmoother> smoothers_;
  std::vector<SmoothRange> last_;  ///< of each sensor, as the map took it
  std::optional<ProvenMap> map_;
  WaySearch way_;
  BodyRoom room_;
  StripGuide guide_;
  Tick next_search_ = 0;
  Tick back_until_ = 0;
  std::optional<Twist> escape_;  ///< till then
  Tick moved_ = 0;               ///< when it was last seen to move
  Pose2 rest_;                   ///< where
};

}  // namespace fulbito
