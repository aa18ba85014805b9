#pragma once

#include <optional>
#include <span>
#include <vector>

#include "navigation/methods/paths/tangent_graph_search.hpp"
#include "navigation/obstacles/path_problem.hpp"

namespace fulbito {

/// Parameters of `TangentPath`.
struct TangentPathParams {
  double margin = 0.005;      ///< [m] between the obstacles and the robot's circumscribed circle
  double hysteresis = 0.03;   ///< share of the path that a change to another side must save
  double approach = 0.08;     ///< [m] length of the straight before a goal with an arrival heading
  double bend = 0.06;         ///< [m] radius of the turn onto that straight
  double narrowing = 0.0025;  ///< [m] beside the robot's flank in narrow gaps, if no wider way is open
};

/// The shortest path for a robot in a scene: the tangent graph with the obstacles inflated by the robot.
///
/// With an arrival heading the path ends with a straight of length `approach` along it, or shorter if a wall
/// is near behind the goal. Two virtual discs of radius `bend`, one on each side of the straight's beginning,
/// let the path enter it only from behind and within 5 degrees. If they leave no way, half that radius is
/// tried, then a corner at which the robot turns in place, and last any arrival direction.
///
/// If there is no way, the obstacles are inflated by the circumscribed circle alone, then by half the robot's
/// width and `narrowing`, for a robot that passes a gap straight.
class TangentPath {
 public:
  enum class Outcome {
    kFound,       ///< as wanted
    kTight,       ///< with less clearance than wanted
    kCorner,      ///< with a corner before the final straight
    kAnyHeading,  ///< without the arrival heading
    kNone,        ///< no way: the path is the straight line to the goal
  };

  explicit TangentPath(TangentPathParams params = {});
  /// Forgets the chosen sides.
  void reset();
  /// Plans from the robot's place.
  /// @param bodies  obstacles without inflation
  /// @param extra   [m] added to the margin, except in the narrower attempts
  Outcome plan(const NavigationScene& scene, std::span<const Circle> bodies, double extra = 0.0);
  /// The circles round which the path bends. Indices from `bodies.size()` on are the virtual discs.
  std::span<const CirclePass> passes() const { return passes_; }
  /// Centre of the circle of `pass`.
  Vec2 centreOf(const CirclePass& pass) const { return circles_[pass.circle].centre; }
  double length() const { return length_; }  ///< [m] of the path up to the straight
  /// The start of the final straight if there is an arrival heading, otherwise the goal.
  Vec2 target() const { return target_; }
  /// Greatest speed [m/s] with which the robot can stop at the corner before the final straight, or at a goal
  /// that it reaches without the wanted heading; infinite on other paths. The shared follower slows down for
  /// bends, but not for turns in place.
  double speedCap(const NavigationScene& scene) const;
  /// The path from the robot to the goal as points at most 1 cm apart, except on the final straight.
  void sample(std::vector<Vec2>& out) const;

 private:
  Outcome choose(const NavigationScene& scene, std::span<const Circle> bodies, double wanted);
  bool searchWithHeading(const NavigationScene& scene, std::span<const Circle> bodies, double inflation);
  bool search(const NavigationScene& scene, std::span<const Circle> bodies, double inflation,
              std::optional<double> bend = {});
  double approachLength(const NavigationScene& scene) const;
  Vec2 addGate(double bend);
  bool onFinalStraight(const NavigationScene& scene) const;

  TangentPathParams params_;
  TangentGraph graph_;
  std::vector<Circle> circles_;
  std::vector<CirclePass> passes_;
  Vec2 start_, goal_, target_;
  Vec2 along_;             ///< direction of the final straight
  double approach_ = 0.0;  ///< [m] length of the final straight
  bool corner_ = false;
  Outcome outcome_ = Outcome::kNone;
  double length_ = 0.0;
  bool found_ = false;
};

}  // namespace fulbito
