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

/// Parameters of `BezierPlanner`.
struct BezierPlannerParams {
  double alpha = 0.0;        ///< [m] added to A = 3 r
  bool all_sides = false;    ///< compare all choices of sides, not only that of the shortest path
  double hysteresis = 0.03;  ///< relative advantage needed over the seeded sides
};

/// The guarded Bezier method. It has the control points of Jung & Lee (2015), but chooses their distance and
/// sides so that the curve is free.
///
/// It makes curves round the obstacles on the line, with control points 4 ... 48 cm away, and takes the
/// shortest one that is clear of all obstacles and walls. It tries the sides of the shortest path
/// (`TangentPath`) first, and the other choices only if those give no curve. If none does, it adds the
/// obstacle nearest to the line to the selection, up to four. If more than four are on the line, it first
/// joins the nearest neighbours to clusters.
///
/// Beyond the paper: for a moving robot a control point ahead makes the curve start along its motion. For an
/// arrival heading there is a control point behind the goal, and another beside it where the curve would come
/// from the front.
class BezierPlanner {
 public:
  explicit BezierPlanner(BezierPlannerParams params = {});
  static constexpr std::size_t kMostClearances = 3;

  /// Plans from the robot's place. Returns the index of the clearance that the curve keeps, or nothing if no
  /// curve is free.
  /// @param bodies      obstacles without inflation
  /// @param shortest    planned for the same scene; gives the sides
  /// @param clearances  [m] to the robot's circumscribed circle: the wanted one first, then smaller ones for
  ///   when no curve keeps it; at most kMostClearances
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
  /// Returns false if the curve is free but leaves the field.
  bool tryCurve(const NavigationScene& scene, std::span<const Vec2> control);
  bool tryEnds(const NavigationScene& scene, std::span<Vec2> control, std::size_t count);
  void keepIfBest(const NavigationScene& scene, std::span<const Vec2> control);
  std::size_t addArrival(Vec2 goal, Vec2 along, double lead, std::span<Vec2> control,
                         std::size_t count) const;

  BezierPlannerParams params_;
  std::array<Level, kMostClearances> levels_;
  std::size_t open_levels_ = 1;  ///< number of levels to try: the first that has a curve and those before it
  std::size_t chosen_ = 0;
  std::vector<std::size_t> selected_;
  std::vector<Group> groups_;
  BezierSamples trial_{};
};

}  // namespace fulbito
