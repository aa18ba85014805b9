#pragma once

#include "navigation/methods/paths/bezier_curve.hpp"
#include "navigation/methods/paths/path_navigator.hpp"

namespace fulbito {

/// The Bezier method of Jung & Lee (2015) as printed, but for three misprints (docs/papers.md): of the 2^n
/// curves round the obstacles on the line, the shortest, without a test whether it is free; most are not.
/// Kept as the comparison's baseline; `bezier` is the one to drive with. An arrival heading is not looked at.
///
/// Of more than eight obstacles on the line the eight nearest to the robot count.
class BezierRaw final : public PathNavigator {
 public:
  struct Params {
    double tbp = 0.33;         ///< [m] of a control point from its obstacle: 130 pixels
    double alpha = 0.0;        ///< [m] added to A = 3 r
    double hysteresis = 0.03;  ///< share by which another choice of sides must be shorter
    Replan replan = Replan::kChange;
  };
  explicit BezierRaw(Params params);

 private:
  void forget() override;
  void makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                std::vector<Vec2>& path) override;
  double curve(const NavigationScene& scene, std::span<const Circle> bodies, std::uint32_t sides,
               BezierSamples& out) const;

  Params params_;
  std::vector<std::size_t> selected_;
  std::vector<std::size_t> kept_selected_;  ///< selection for which `kept_sides_` was chosen
  std::uint32_t kept_sides_ = 0;            ///< bit i: selected obstacle i is passed at its end B
  BezierSamples shortest_{};
  BezierSamples trial_{};
};

}  // namespace fulbito
