#pragma once

#include "navigation/methods/paths/path_navigator.hpp"
#include "navigation/methods/paths/tangent_path.hpp"
#include "navigation/obstacles/path_problem.hpp"

namespace fulbito {

/// Appends the cubic Hermite curve from `a` to `b` with derivatives `da` and `db` [m per unit parameter],
/// without its first point, in pieces of about `spacing` [m], 8 to 2000 of them.
void appendHermite(Vec2 a, Vec2 da, Vec2 b, Vec2 db, double spacing, std::vector<Vec2>& out);

/// Drives cubic Hermite segments (named by Jung & Lee 2015 as future work) through the shortest path's bends:
/// one joint in the middle of each arc, along the circle, so that a curve begins to turn before the circle
/// and ends after it. Ends along an arrival heading. The same guard as the Bezier method's tests the curve;
/// while it touches, the circles of the shortest path are made larger, up to 4 cm; then that path itself is
/// driven.
class Hermite final : public PathNavigator {
 public:
  struct Params : PathNavigatorParams {
    double clearance = 0.01;   ///< [m] beside the robot's circumscribed circle
    double tension = 1.0;      ///< of the joints: length of a derivative over the chord
    double hysteresis = 0.03;  ///< see TangentPathParams
  };
  /// How the plans since the construction came out.
  struct Counts {
    std::uint64_t plans = 0;
    std::uint64_t tangent = 0;  ///< no curve was free: the tangent graph's path
    std::uint64_t blocked = 0;  ///< no way at all
  };
  explicit Hermite(Params params);
  const Counts& counts() const { return counts_; }

 private:
  struct Joint {
    Vec2 place;
    Vec2 direction;
  };
  void forget() override;
  void makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                std::vector<Vec2>& path) override;
  double speedCap(const NavigationScene& scene) const override;
  void placeJoints(const NavigationScene& scene);
  void drawCurve(std::vector<Vec2>& path) const;

  double clearance_;
  double tension_;
  TangentPath tangent_path_;
  PathGuard guard_;
  std::vector<Joint> joints_;
  bool on_tangent_path_ = false;
  Counts counts_;
};

}  // namespace fulbito
