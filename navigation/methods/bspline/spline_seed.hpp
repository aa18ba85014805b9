#pragma once

#include <optional>
#include <span>
#include <vector>

#include "navigation/geometry/cubic_spline.hpp"
#include "navigation/methods/paths/tangent_graph_search.hpp"
#include "navigation/obstacles/forecast.hpp"

namespace fulbito {

/// The ends and conditions of an initial spline.
struct SeedRequest {
  Vec2 start;
  std::optional<Vec2> start_direction;  ///< unit vector if the robot moves at the start
  Vec2 goal;
  std::optional<Vec2> end_direction;  ///< unit vector of the arrival direction
  double speed = 1.0;                 ///< [m/s] guess of the mean speed, to predict moving discs
  double margin = 0.005;              ///< [m] from the shortest path to the turning circle
};

/// Makes the splines that the optimisation begins with: the shortest way among the discs for the robot's
/// circumscribed circle or for its half width, and the shortest ways that pass one disc on the other side.
class SplineSeeder {
 public:
  /// Width of the robot for which the way has room.
  enum class Room {
    kTurning,   ///< circumscribed circle plus the request's margin: the robot can turn anywhere
    kStraight,  ///< half the width plus 2 mm: the robot must enter gaps straight
  };
  SplineSeeder();
  /// Searches for the shortest way. Returns false if there is none; the seed is then straight.
  bool search(const SeedRequest& request, const RobotModel& robot, const FieldGeometry& field,
              std::span<const ForecastDisc> discs, Room room);
  /// Length [m] of the shortest way.
  double length() const { return length_; }
  /// Number of discs that the shortest way bends around.
  std::size_t bends() const { return passes_.size(); }
  /// The shortest way's spline.
  const CubicSpline& shortest() const { return shortest_; }
  /// Makes the spline of the way that passes bend `bend` on the other side. Returns false if it is more than
  /// `excess` times as long.
  bool otherSide(std::size_t bend, double excess, CubicSpline& out);

 private:
  void placeCircles(double inflation, std::span<const ForecastDisc> discs);
  bool route(SidePreference preference);
  void makeSpline(CubicSpline& out) const;

  SeedRequest request_;
  const FieldGeometry* field_ = nullptr;
  double wall_margin_ = 0.0;
  Vec2 from_, to_;
  TangentGraph graph_;
  std::vector<Circle> circles_;
  std::vector<CirclePass> passes_;
  double length_ = 0.0;
  std::vector<Vec2> way_;
  CubicSpline shortest_;
};

}  // namespace fulbito
