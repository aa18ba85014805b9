#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navigation/methods/paths/bezier_curve.hpp"
#include "navigation/methods/paths/tangent_path.hpp"
#include "navigation/obstacles/path_problem.hpp"

namespace fulbito {

/// How `BezierPlanner` plans.
struct BezierPlannerParams {
  double alpha = 0.0;        ///< [m] added to A = 3 r
  bool all_sides = false;    ///< compare all choices of sides, not only the shortest path's
  double hysteresis = 0.03;  ///< share by which a curve must be shorter than the one on the seeded sides
};

/// The guarded Bezier method: control points as in Jung & Lee (2015), but with their distance and
/// the sides chosen so that the curve is free.
///
/// Of the curves round the obstacles on the line, with control points 4 ... 48 cm away, it keeps those that
/// are clear of all obstacles and walls and takes the shortest. The sides on which the shortest path
/// (`TangentPath`) passes are tried first, the other choices only where those give no curve. If none does,
/// the obstacle nearest to the line joins the selection, up to four; more than four on the line are joined to
/// clusters first, nearest neighbours first.
///
/// Completions: a robot in motion gets a control point ahead of it, so that the curve starts along its
/// motion. An arrival heading gets a control point behind the goal, and where the curve would come from the
/// front another beside that.
class BezierPlanner {
 public:
  explicit BezierPlanner(BezierPlannerParams params = {});
  static constexpr std::size_t kMostClearances = 3;

  /// Plans from the robot's place. The result is the index of the clearance that the curve keeps, or nothing
  /// when no curve is free.
  /// @param bodies      obstacles without inflation
  /// @param shortest    planned on the same scene; gives the sides
  /// @param clearances  [m] beside the robot's circumscribed circle, the wanted one first, then what will do
  ///                    where no selection of obstacles gives a curve; at most kMostClearances
  std::optional<std::size_t> plan(const NavigationScene& scene, std::span<const Circle> bodies,
                                  const TangentPath& shortest, std::span<const double> clearances);
  const BezierSamples& path() const { return levels_[chosen_].path; }
  double length() const { return levels_[chosen_].length; }  ///< [m]

 private:
  static constexpr std::size_t kMostGroups = 4;
  struct Group {
    Circle disc;
    Vec2 seed;  ///< unit vector to the side on which the shortest path passes
  };

  /// The best curve for one clearance.
  struct Level {
    PathGuard guard;
    BezierSamples path{};
    double length = 0.0;
    double to_beat = 0.0;
  };

  void group(const NavigationScene& scene, std::span<const Circle> bodies, const TangentPath& shortest);
  void joinNearest();
  bool addNearest(const NavigationScene& scene, std::span<const Circle> bodies);
  int seededSide(const NavigationScene& scene, const TangentPath& shortest, Vec2 centre) const;
  void trySides(const NavigationScene& scene, std::uint32_t flips);
  /// False when the curve is free but leaves the field.
  bool tryCurve(const NavigationScene& scene, std::span<const Vec2> control);
  bool tryEnds(const NavigationScene& scene, std::span<Vec2> control, std::size_t count);
  void keepIfBest(const NavigationScene& scene, std::span<const Vec2> control);
  std::size_t addArrival(Vec2 goal, Vec2 along, double lead, std::span<Vec2> control,
                         std::size_t count) const;

  BezierPlannerParams params_;
  std::array<Level, kMostClearances> levels_;
  std::size_t open_levels_ = 1;  ///< levels worth looking at: the first that has a curve and those before
  std::size_t chosen_ = 0;
  std::vector<std::size_t> selected_;
  std::vector<Group> groups_;
  BezierSamples trial_{};
};

}  // namespace fulbito
