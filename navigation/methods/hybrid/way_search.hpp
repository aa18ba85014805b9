#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "navigation/obstacles/proven_map.hpp"

namespace fulbito {

/// The cheapest way to the goal over the map about the robot, by A* on its cells. Unknown cells are free.
///  - Certain surfaces nearer than half the robot's width are never passed; others cost more, so that a robot
///    goes and looks.
///  - Near surfaces cost more, so that ways keep to the middle.
///  - A straight face is taken to go on where nothing has shown the opposite: where its cells were not seen
///    free from the direction in which they would be heard.
///  - Cells that were not seen free from where the way comes cost more: a face that is seen aslant is silent.
///  - The way of the last search is cheaper, so that the robot does not waver between two.
class WaySearch {
 public:
  WaySearch();
  /// Forgets the last way.
  void reset() { path_.clear(); }
  /// @param half_width  [m] of the robot
  void search(const ProvenMap& map, Vec2 from, Vec2 goal, double half_width);
  /// From the robot to the goal or to the edge of the window; empty where there is no way.
  std::span<const Vec2> path() const { return path_; }
  /// Distance [m] of `place` to the nearest occupied cell, as the last search saw it; at most 16 cells.
  double clearance(const ProvenMap& map, Vec2 place) const;

  static constexpr int kSide = 116;  ///< cells a side of the window

 private:
  struct Node {
    float total;
    float cost;
    int index;
  };
  static int indexOf(int x, int y) { return y * kSide + x; }
  static bool isInside(int x, int y) { return x >= 0 && y >= 0 && x < kSide && y < kSide; }
  void measure(const ProvenMap& map);
  void stamp(int x, int y, bool certain);
  Vec2 normalAt(const ProvenMap& map, int x, int y, Vec2 heard) const;
  void extend(const ProvenMap& map, int x, int y, const ProvenMap::Cell& cell);
  void suspect(int x, int y);
  void markLast(const ProvenMap& map);
  double weight(int index, int from_start2) const;
  void visit(const Node& node, float rest, int index, float length);
  int expand(const ProvenMap& map, Vec2 from, Vec2 goal);

  int x_ = 0, y_ = 0;                       ///< the window's lowest cell
  double half_width_ = 0.0;                 ///< [cells]
  std::array<double, 16> step_{};           ///< [cells] length of each step
  std::array<std::uint32_t, 16> whence_{};  ///< where each step comes from, as of `ProvenMap::about`
  std::vector<float> table_;                ///< [cells] distances between cells
  std::vector<float> any_;                  ///< [cells] to the nearest occupied cell
  std::vector<float> certain_;              ///< [cells] to the nearest certain one
  std::vector<std::uint8_t> suspect_, last_;
  std::vector<float> cost_;
  std::vector<int> parent_;
  std::vector<Node> open_;
  std::vector<Vec2> path_;
};

}  // namespace fulbito
