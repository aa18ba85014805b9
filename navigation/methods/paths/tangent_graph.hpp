#pragma once

#include "navigation/methods/paths/path_navigator.hpp"
#include "navigation/methods/paths/tangent_path.hpp"

namespace fulbito {

/// Follows the exact shortest path among the discs (`TangentPath`), whose length L* is the reference of the
/// comparison.
class TangentGraphNavigator final : public PathNavigator {
 public:
  struct Params : PathNavigatorParams {
    double margin = 0.005;     ///< [m], see TangentPathParams
    double hysteresis = 0.03;  ///< see TangentPathParams
    double approach = 0.08;    ///< [m], see TangentPathParams
    double bend = 0.06;        ///< [m], see TangentPathParams
  };
  explicit TangentGraphNavigator(Params params);

 private:
  void forget() override;
  void makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                std::vector<Vec2>& path) override;
  double speedCap(const NavigationScene& scene) const override;

  TangentPath tangent_path_;
};

}  // namespace fulbito
