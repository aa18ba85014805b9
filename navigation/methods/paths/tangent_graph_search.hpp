#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// One circle round which a shortest path bends.
struct CirclePass {
  std::size_t circle = 0;  ///< index of the circle in the searched circles
  int side = 1;            ///< +1: counter-clockwise, the circle is on the left of the path; -1: on the right
  double radius = 0.0;     ///< [m] of the bend: the circle's radius, or less if it held the start or the goal
  Vec2 entry;              ///< [m] where the path reaches the circle
  Vec2 exit;               ///< [m] where the path leaves the circle
  double sweep = 0.0;      ///< [rad] >= 0, turn on the circle
};

/// Preferred sides: a pass on the other side of a listed circle counts as `penalty` [m] longer.
struct SidePreference {
  std::span<const CirclePass> passes;
  double penalty = 0.0;
};

/// Exact shortest path of a point among discs, from tangent segments and arcs, by A* search (the tangent
/// graph; Latombe 1991 calls it the generalised visibility graph). The search makes tangents when it reaches
/// their circle and tests them for collision when they come first in the queue, so that it tests few of them.
///
/// Discs may overlap. A disc that holds the start or the goal shrinks until the point is on its edge. A wall
/// that is nearer to one of them than the margin moves out to it. So tracking errors of a millimetre change
/// the path by a millimetre, and there is always a way out.
///
/// Cost: O(n) for each tested tangent, at most 4 n^2 of them; the test's survey has measurements. The graph
/// keeps its memory between searches and only allocates for more circles than before.
class TangentGraph {
 public:
  /// @param reserved_circles  number of circles for which the constructor allocates memory
  explicit TangentGraph(std::size_t reserved_circles = 16);

  /// Finds the shortest path. Returns false if there is none.
  /// @param bounds       field whose walls are at least `wall_margin` [m] away; null: no walls. The insides
  ///   of the goals count as outside.
  /// @param preference   see `SidePreference`
  bool search(Vec2 start, Vec2 goal, std::span<const Circle> circles, const FieldGeometry* bounds = nullptr,
              double wall_margin = 0.0, SidePreference preference = {});

  /// Length [m] of the last path, without penalties; infinite if there was none.
  double length() const { return length_; }
  /// The circles round which the path bends, in order; empty for a straight path.
  std::span<const CirclePass> passes() const { return passes_; }
  /// The path from the start to the goal as points at most `spacing` [m] apart, on the circle for arcs. At
  /// most 2000 points per tangent or arc; empty if there was no path.
  void sample(double spacing, std::vector<Vec2>& out) const;

 private:
  /// A circle with a direction of travel. The start and the goal are ports of radius 0.
  struct Port {
    Vec2 centre;
    double signed_radius = 0.0;  ///< positive: counter-clockwise
  };
  /// The directed tangent between two ports. A heading identifies a place on a circle.
  struct Tangent {
    enum class State : std::uint8_t { kNone, kOpen, kClosed };
    Vec2 direction;        ///< of travel
    double heading = 0.0;  ///< [rad] of `direction`
    double length = 0.0;
    double cost = 0.0;  ///< [m] least known cost from the start to the tangent's end
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

  std::size_t count_ = 0;   ///< number of circles
  std::size_t stride_ = 0;  ///< number of ports: two per circle, the start and the goal
  Vec2 start_, goal_;
  std::vector<Port> ports_;
  std::vector<double> penalties_;        ///< [m] for entering each port
  std::vector<Tangent> tangents_;        ///< stride_ x stride_
  std::vector<std::uint8_t> made_;       ///< per port: whether its tangents are in the table
  std::vector<std::uint32_t> arrivals_;  ///< per port: its first expanded arrival
  std::vector<double> blockers_;         ///< [rad] middles of the closed stretches of each circle
  std::vector<std::size_t> blockers_begin_;
  std::array<Wall, 8> walls_;
  std::size_t wall_count_ = 0;
  std::vector<Entry> queue_;
  std::vector<std::uint32_t> chain_;
  std::vector<CirclePass> passes_;
  double length_ = 0.0;
};

}  // namespace fulbito
