#pragma once

#include <vector>

#include "fulbito/detail/arc.hpp"
#include "navigation/interface/parameters.hpp"
#include "navigation/methods/paths/replan_monitor.hpp"

namespace fulbito {

/// What the methods of constant curvature share. A curve is kept until the goal moves or the robot is 2 cm
/// off it; then a new one starts from where the robot is. Where the curve is too long a detour or leaves the
/// field, the path is the straight line, for which the follower first turns the robot on the spot. Obstacles
/// are not looked at.
class CurveNavigator : public Navigator {
 public:
  struct Params {
    double detour = 2.0;  ///< longest curve over the straight distance
  };
  void reset() final;
  Guidance plan(const NavigationScene& scene) final;

 protected:
  explicit CurveNavigator(Params params);
  /// Appends the curve to `path`, which holds the robot's place. Returns its length [m], which may be
  /// infinite; such a curve is not driven.
  virtual double makeCurve(const NavigationScene& scene, std::vector<Vec2>& path) = 0;
  /// Forgets what the method itself remembers.
  virtual void forget() = 0;

 private:
  void makePath(const NavigationScene& scene);

  Params params_;
  ReplanMonitor monitor_;
  std::vector<Vec2> path_;
  std::uint64_t revision_ = 0;
};

/// Appends points along an arc of finite length, without its start and with its end.
void appendArc(const Arc& arc, std::vector<Vec2>& out);

/// The shared parameter, for the table of a method.
std::vector<Parameter<CurveNavigator::Params>> curveParameters();

}  // namespace fulbito
