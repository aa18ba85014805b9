#pragma once

#include <vector>

#include "navigation/interface/parameters.hpp"
#include "navigation/methods/paths/replan_monitor.hpp"

namespace fulbito {

/// When a path method plans, and how it handles moving obstacles.
struct PathNavigatorParams {
  double horizon = 0.5;  ///< [s] greatest prediction of moving obstacles; 0: they count as standing still
  double yield = 1.0;    ///< [s] look ahead of yieldSpeed; 0: the robot never slows down for obstacles
  Replan replan = Replan::kChange;
};

/// Common base of the path methods. It plans with obstacles at the places where the robot will meet them and
/// keeps the path until the scene changes or the robot leaves it. It slows down for obstacles that cross the
/// path.
class PathNavigator : public Navigator {
 public:
  void reset() final;
  Guidance plan(const NavigationScene& scene) final;

 protected:
  explicit PathNavigator(PathNavigatorParams params);
  /// Forgets the state of the derived method.
  virtual void forget() = 0;
  /// Plans from the robot's place.
  /// @param bodies  obstacles without inflation, at the places where the robot will meet them
  /// @param path    the present path, to be replaced by the new one of at least 2 points
  virtual void makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                        std::vector<Vec2>& path) = 0;
  /// Greatest speed [m/s] on the present path, apart from moving obstacles; infinite by default.
  virtual double speedCap(const NavigationScene& scene) const;

 private:
  PathNavigatorParams params_;
  ReplanMonitor monitor_;
  std::vector<Circle> bodies_;
  std::vector<Vec2> path_;
  std::uint64_t revision_ = 0;
};

/// Describes the parameter `replan` for the member `replan` of `P`.
template <typename P>
Parameter<P> replanParameter() {
  return choice<P, Replan>("replan", &P::replan, {"change", "tick"}, "when to plan again");
}

/// Adds the parameters `horizon`, `yield` and `replan` to those of `P`, which derives from
/// PathNavigatorParams.
template <typename P>
std::vector<Parameter<P>> withPathParameters(std::vector<Parameter<P>> parameters) {
  parameters.push_back(
      number<P>("horizon", &P::horizon, 0.0, 2.0, "s", "farthest look ahead at moving obstacles"));
  parameters.push_back(number<P>("yield", &P::yield, 0.0, 2.0, "s",
                                 "look ahead for slowing down before obstacles; 0 = never"));
  parameters.push_back(replanParameter<P>());
  return parameters;
}

}  // namespace fulbito
