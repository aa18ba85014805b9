#pragma once

#include <vector>

#include "fulbito/detail/arc.hpp"
#include "navigation/interface/parameters.hpp"
#include "navigation/methods/paths/replan_monitor.hpp"

namespace fulbito {

/// Common base of the methods with constant curvature. It keeps a curve until the goal moves or the robot is
/// 2 cm off the curve, then makes a new one from the robot's place. If the curve is too long or leaves the
/// field, the path is the straight line to the goal, and the follower first turns the robot in place. The
/// methods ignore obstacles.
class CurveNavigator : public Navigator {
 public:
  struct Params {
    double detour = 2.0;  ///< greatest length of a curve relative to the straight distance
  };
  void reset() final;
  Guidance plan(const NavigationScene& scene) final;

 protected:
  explicit CurveNavigator(Params params);
  /// Appends the curve to `path`, which already holds the robot's place. Returns its length [m]; a curve of
  /// infinite length is not driven.
  virtual double makeCurve(const NavigationScene& scene, std::vector<Vec2>& path) = 0;
  /// Forgets the state of the derived method.
  virtual void forget() = 0;

 private:
  void makePath(const NavigationScene& scene);

  Params params_;
  ReplanMonitor monitor_;
  std::vector<Vec2> path_;
  std::uint64_t revision_ = 0;
};

/// Appends points along an arc of finite length, including its end but not its start.
void appendArc(const Arc& arc, std::vector<Vec2>& out);

/// The parameter `detour` for the table of a method.
std::vector<Parameter<CurveNavigator::Params>> curveParameters();

}  // namespace fulbito
