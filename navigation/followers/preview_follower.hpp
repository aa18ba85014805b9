#pragma once

#include "fulbito/navigation.hpp"
#include "navigation/followers/path_tracker.hpp"
#include "navigation/followers/speed_profile.hpp"

namespace fulbito {

/// Parameters of the preview follower. The defaults are those of the comparison.
struct PreviewParams {
  double lookahead = 0.03;          ///< [m] steering point ahead of the robot at rest
  double lookahead_time = 0.04;     ///< [s] additional look-ahead distance per speed
  double yaw_gain = 10.0;           ///< [1/s] least gain from bearing error to yaw rate
  double acceleration_share = 0.6;  ///< share of the wheel acceleration, for braking before bends
  double lateral_share = 0.6;       ///< share of the lateral grip, in bends
  double spin_above = 0.785398;     ///< [rad] a robot that starts with a larger bearing error turns in place
  double spin_until = 0.174533;     ///< [rad] bearing error at which that turn ends
};

/// The follower that all methods share, so that comparisons rate methods and not controllers. It previews a
/// polyline: a path, or 40 points integrated through a heading field. It steers at a point some centimetres
/// ahead and drives as fast as the bends in the preview allow. A timed path is driven at its own speeds. A
/// slow robot at a goal with a heading turns to it in place.
class PreviewFollower final : public Follower {
 public:
  explicit PreviewFollower(PreviewParams params = {});
  void reset() override;
  Twist follow(const Guidance& guidance, const NavigationScene& scene) override;

 private:
  struct Ahead {
    Vec2 target;   ///< steering point
    double speed;  ///< [m/s] allowed now
  };
  bool slowAtGoal(const NavigationScene& scene) const;
  Ahead aheadOnField(const Guidance& guidance, const NavigationScene& scene, double speed, double reach);
  Ahead aheadOnPath(const Guidance& guidance, const NavigationScene& scene, double speed, double reach);
  void cachePath(const Guidance& guidance, const NavigationScene& scene);
  void timeCached(const NavigationScene& scene);
  Twist steer(const Ahead& ahead, const NavigationScene& scene, double speed, bool timed);

  PreviewParams params_;
  PathTracker tracker_;
  std::vector<Vec2> points_;  ///< preview, or the whole path resampled
  std::vector<double> curvature_;
  std::vector<double> speeds_;
  std::uint64_t cached_revision_ = 0;
  bool cached_ = false;
  bool started_ = false;
  bool spinning_ = false;
};

}  // namespace fulbito
