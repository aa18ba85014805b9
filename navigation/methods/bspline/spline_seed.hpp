#pragma once

#include <optional>
#include <span>
#include <vector>

#include "navigation/geometry/cubic_spline.hpp"
#include "navigation/methods/paths/tangent_graph_search.hpp"
#include "navigation/obstacles/forecast.hpp"

namespace fulbito {

/// What a first spline shall join.
struct SeedRequest {
  Vec2 start;
  std::optional<Vec2> start_direction;  ///< unit vector of a start in motion
  Vec2 goal;
  std::optional<Vec2> end_direction;  ///< unit vector to arrive along
  double speed = 1.0;                 ///< [m/s] guess of the mean, to place moving discs
  double margin = 0.005;              ///< [m] that the shortest path keeps from the turning robot
};

/// Makes the splines that the optimisation begins with: the shortest way among the discs for the robot's
/// circumscribed circle or for its half width, and the shortest ways that pass one disc on the other side.
class SplineSeeder {
 public:
  /// Room that the way leaves beside its middle.
  enum class Room {
    kTurning,   ///< the circumscribed circle and the request's margin: the robot can turn anywhere
    kStraight,  ///< half the width and 2 mm: gaps have to be entered straight
  };
  SplineSeeder();
  /// Searches the shortest way; false when there is none (then the seed is straight).
  bool search(const SeedRequest& request, const RobotModel& robot, const FieldGeometry& field,
              std::span<const ForecastDisc> discs, Room room);
  /// Length [m] of the shortest way.
  double length() const { return length_; }
  /// Discs that the shortest way bends around.
  std::size_t bends() const { return passes_.size(); }
  /// The shortest way's spline.
  const CubicSpline& shortest() const { return shortest_; }
  /// The spline of the way that passes bend `bend` on the other side; false when it is more than `excess`
  /// times as long.
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
