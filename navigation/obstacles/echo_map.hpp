#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// A robot's short memory of what its range sensors heard: a small occupancy grid that moves with the robot
/// and stays aligned with the world. An echo speaks for the cells at its range across the cone, most for
/// those near the axis, and against all nearer ones; silence speaks against the whole cone. So an echo of
/// unknown bearing is narrowed down as the robot moves and turns.
class EchoMap {
 public:
  struct Settings {
    double cell = 0.008;         ///< [m] side of a cell
    double window = 0.42;        ///< [m] from the robot to the edge of the grid, at least
    double memory = 2.0;         ///< [s] cells that no sensor spoke for in this time are forgotten
    double free_weight = 2.0;    ///< evidence of a farther echo against a cell; one for a cell weighs 1
    double silent_weight = 0.7;  ///< evidence of silence against a cell
    double band = 0.008;         ///< [m] before an echo's range that its cells begin
    /// [m] Silence and far echoes clear nothing so near to a sonar: close faces throw sound off sideways.
    double near = 0.05;
    double threshold = 1.0;  ///< evidence that makes a cell occupied
    double most = 4.0;       ///< evidence beyond which nothing is added
  };

  explicit EchoMap(const Settings& settings);
  /// Forgets everything.
  void reset();
  /// Takes in the scene's readings of one tick.
  void update(const NavigationScene& scene);

  /// Nearest occupied cell in every sector about `pose`, robot frame. Cells nearer than `range` count.
  void scan(const SectorCircle& circle, const Pose2& pose, double range, std::span<SectorHit> hits) const;
  /// Appends discs that cover the occupied cells: at most one per square of `kDiscCells` cells a side.
  void appendDiscs(std::vector<DiscObstacle>& discs) const;

  static constexpr int kDiscCells = 3;

 private:
  struct Cell {
    float evidence = 0.0f;  ///< for > 0, against < 0
    std::int32_t tick = 0;  ///< when a sensor last spoke for it
  };

  void centre(Vec2 position);
  struct Call;
  void takeIn(const RangeReading& reading, const Pose2& pose);
  void weigh(const Call& call, Cell& cell, Vec2 to) const;
  void clearBody(const NavigationScene& scene);
  bool isOccupied(const Cell& cell) const;
  Cell& at(int x, int y);
  const Cell& at(int x, int y) const;
  Vec2 middle(int x, int y) const { return {(x + 0.5) * settings_.cell, (y + 0.5) * settings_.cell}; }
  int cellOf(double coordinate) const;
  template <typename Work>
  void forOccupied(const Work& work) const;

  Settings settings_;
  int size_;    ///< cells a side that are used
  int stride_;  ///< cells a side that are kept, a power of two
  bool placed_ = false;
  int x_ = 0, y_ = 0;  ///< the grid's lowest cell
  Tick now_ = 0;
  Tick memory_ticks_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace fulbito
