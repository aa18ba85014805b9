#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// One circle that a shortest path bends around.
struct CirclePass {
  std::size_t circle = 0;  ///< index in the circles that were searched
  int side = 1;            ///< +1: counter-clockwise, the circle is on the left of the path; -1: on the right
  double radius = 0.0;     ///< [m] of the bend: the circle's, or less where it held the start or the goal
  Vec2 entry;              ///< where the path reaches the circle
  Vec2 exit;               ///< where it leaves
  double sweep = 0.0;      ///< [rad] >= 0 turned on the circle
};

/// Sides to hold on to: a pass on the other side of a named circle counts as `penalty` [m] longer.
struct SidePreference {
  std::span<const CirclePass> passes;
  double penalty = 0.0;
};

/// Exact shortest path of a point among discs: tangent segments and arcs, searched by A* (the tangent graph;
/// Latombe 1991 names it the generalised visibility graph). Tangents are made when their circle is reached
/// and tested for collision when they come first in the queue, so that a search touches few of them.
///
/// Discs may overlap. A disc that holds the start or the goal is shrunk until the point lies on its edge, and
/// a wall that is nearer to one of them than the margin is moved out to it: tracking errors of a millimetre
/// then change the path by a millimetre, and the way out is never lost.
///
/// Cost: O(n) for each tangent tested, at most 4 n^2 of them; measured figures are in the test's survey.
/// Memory is kept between searches; a graph that has seen as many circles allocates nothing.
class TangentGraph {
 public:
  /// @param reserved_circles  number of circles for which memory is taken at once
  explicit TangentGraph(std::size_t reserved_circles = 16);

  /// Finds the shortest path; false when there is none.
  /// @param bounds       walls that tangents and arcs keep `wall_margin` [m] away from; null = no walls.
  ///                     The insides of the goals count as outside.
  /// @param preference   see `SidePreference`
  bool search(Vec2 start, Vec2 goal, std::span<const Circle> circles, const FieldGeometry* bounds = nullptr,
              double wall_margin = 0.0, SidePreference preference = {});

  /// Length [m] of the path found, without penalties; infinite when there was none.
  double length() const { return length_; }
  /// The circles that the path bends around, in order; empty for a straight path.
  std::span<const CirclePass> passes() const { return passes_; }
  /// The path as points at most `spacing` [m] apart, from the start to the goal; arcs have their points on
  /// the circle. At most 2000 points a tangent or arc; empty when there was no path.
  void sample(double spacing, std::vector<Vec2>& out) const;

 private:
  /// A circle with a direction of travel, or (radius 0) the start or the goal.
  struct Port {
    Vec2 centre;
    double signed_radius = 0.0;  ///< positive: counter-clockwise
  };
  /// The one directed tangent between two ports. Headings stand for places on a circle.
  struct Tangent {
    enum class State : std::uint8_t { kNone, kOpen, kClosed };
    Vec2 direction;        ///< of travel
    double heading = 0.0;  ///< [rad] of `direction`
    double length = 0.0;
    double cost = 0.0;  ///< [m] best known from the start to its end
    std::uint32_t parent = 0;
    std::uint32_t next_arrival = 0;
    State state = State::kNone;
  };
  struct Entry {
    double estimate;
    double cost;
    std::uint32_t tangent;
  };
  struct Wall {
    Vec2 outward;
    double offset = 0.0;  ///< points with dot(outward, p) <= offset are allowed
    double angle = 0.0;   ///< [rad] of `outward`
  };

  void place(Vec2 start, Vec2 goal, std::span<const Circle> circles);
  void placeWalls(const FieldGeometry& bounds, double margin);
  void findBlockers();
  void prefer(const SidePreference& preference);
  void makeTangents(std::size_t from);
  void expand(std::size_t from, std::uint32_t arrival);
  bool dominated(std::size_t port, std::uint32_t arrival) const;
  bool tangentFree(std::size_t from, std::size_t to, const Tangent& tangent) const;
  double freeSweep(std::size_t port, double heading) const;
  Vec2 contact(std::size_t port, Vec2 direction) const;
  void trace(std::uint32_t last);

  std::size_t count_ = 0;   ///< circles
  std::size_t stride_ = 0;  ///< ports: two a circle, the start, the goal
  Vec2 start_, goal_;
  std::vector<Port> ports_;
  std::vector<double> penalties_;        ///< [m] for entering each port
  std::vector<Tangent> tangents_;        ///< stride_ x stride_
  std::vector<std::uint8_t> made_;       ///< per port: its tangents are in the table
  std::vector<std::uint32_t> arrivals_;  ///< per port: first of the expanded arrivals
  std::vector<double> blockers_;         ///< [rad] centres of the closed stretches of each circle
  std::vector<std::size_t> blockers_begin_;
  std::array<Wall, 8> walls_;
  std::size_t wall_count_ = 0;
  std::vector<Entry> queue_;
  std::vector<std::uint32_t> chain_;
  std::vector<CirclePass> passes_;
  double length_ = 0.0;
};

}  // namespace fulbito
