#pragma once

#include "navigation/methods/paths/bezier_curve.hpp"
#include "navigation/methods/paths/path_navigator.hpp"

namespace fulbito {

/// The Bezier method of Jung & Lee (2015) as printed, except for three misprints (docs/papers.md). It takes
/// the shortest of the 2^n curves round the obstacles on the line without a test for collisions; most curves
/// collide. It is the baseline of the comparison; use `bezier` to drive. It ignores the arrival heading.
///
/// If more than eight obstacles are on the line, the eight nearest to the robot count.
class BezierRaw final : public PathNavigator {
 public:
  struct Params {
    double tbp = 0.33;         ///< [m] from an obstacle to its control point: 130 pixels in the paper
    double alpha = 0.0;        ///< [m] added to A = 3 r
    double hysteresis = 0.03;  ///< relative advantage that another choice of sides needs
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
  std::vector<std::size_t> kept_selected_;  ///< selection to which `kept_sides_` belongs
  std::uint32_t kept_sides_ = 0;            ///< bit i: the curve passes selected obstacle i at its end B
  BezierSamples shortest_{};
  BezierSamples trial_{};
};

}  // namespace fulbito
