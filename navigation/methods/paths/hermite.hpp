#pragma once

#include "navigation/methods/paths/path_navigator.hpp"
#include "navigation/methods/paths/tangent_path.hpp"
#include "navigation/obstacles/path_problem.hpp"

namespace fulbito {

/// Appends the cubic Hermite curve from `a` to `b` with the derivatives `da` and `db` [m per unit of the
/// parameter], without its first point. It has 8 to 2000 pieces of about `spacing` [m].
void appendHermite(Vec2 a, Vec2 da, Vec2 b, Vec2 db, double spacing, std::vector<Vec2>& out);

/// Drives cubic Hermite segments (mentioned by Jung & Lee 2015 as future work) through the bends of the
/// shortest path. There is one joint in the middle of each arc, along the circle, so that a curve begins to
/// turn before the circle and ends after it. At the goal the curve has the arrival heading. The guard of the
/// Bezier method tests the curve. While it collides, the circles of the shortest path grow, up to 4 cm; after
/// that the robot drives the shortest path itself.
class Hermite final : public PathNavigator {
 public:
  struct Params : PathNavigatorParams {
    double clearance = 0.01;   ///< [m] gap to the robot's circumscribed circle
    double tension = 1.0;      ///< length of a derivative at a joint relative to the chord
    double hysteresis = 0.03;  ///< see TangentPathParams
  };
  /// Numbers of plans by outcome since the construction.
  struct Counts {
    std::uint64_t plans = 0;
    std::uint64_t tangent = 0;  ///< plans without a free curve: the tangent graph's path
    std::uint64_t blocked = 0;  ///< plans without any way
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
