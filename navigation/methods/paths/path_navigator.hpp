#pragma once

#include <vector>

#include "navigation/interface/parameters.hpp"
#include "navigation/methods/paths/replan_monitor.hpp"

namespace fulbito {

/// When a path method plans, and how it copes with moving obstacles.
struct PathNavigatorParams {
  double horizon = 0.5;  ///< [s] farthest look ahead at moving obstacles; 0: they are taken to stand still
  double yield = 1.0;    ///< [s] look ahead of yieldSpeed; 0: it never slows down for them
  Replan replan = Replan::kChange;
};

/// What the path methods share: obstacles are planned with where they will be met, the path is kept until the
/// scene changes or the robot strays from it, and the robot slows down for obstacles that come across it.
class PathNavigator : public Navigator {
 public:
  void reset() final;
  Guidance plan(const NavigationScene& scene) final;

 protected:
  explicit PathNavigator(PathNavigatorParams params);
  /// Forgets what the method itself remembers.
  virtual void forget() = 0;
  /// Plans from the robot's place.
  /// @param bodies  obstacles without inflation, where they will be met
  /// @param path    the path in use, to be replaced by the new one of at least 2 points
  virtual void makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                        std::vector<Vec2>& path) = 0;
  /// [m/s] that the robot may drive on the path in use, moving obstacles apart; infinite by default.
  virtual double speedCap(const NavigationScene& scene) const;

 private:
  PathNavigatorParams params_;
  ReplanMonitor monitor_;
  std::vector<Circle> bodies_;
  std::vector<Vec2> path_;
  std::uint64_t revision_ = 0;
};

/// The parameter `replan` of the member `replan` of `P`.
template <typename P>
Parameter<P> replanParameter() {
  return choice<P, Replan>("replan", &P::replan, {"change", "tick"}, "when to plan again");
}

/// Adds the parameters `horizon`, `yield` and `replan` to those of a `P` that is a PathNavigatorParams.
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
