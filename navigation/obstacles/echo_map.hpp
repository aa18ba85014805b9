#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// A robot's short memory of the readings of its range sensors: a small occupancy grid that moves with the
/// robot and stays aligned with the world. An echo is evidence for the cells at its range across the cone,
/// most for those near the axis, and against all nearer cells. Silence is evidence against the whole cone. So
/// the place of an echo, whose bearing is unknown, becomes clear as the robot moves and turns.
class EchoMap {
 public:
  struct Settings {
    double cell = 0.008;         ///< [m] side of a cell
    double window = 0.42;        ///< [m] least distance from the robot to the edge of the grid
    double memory = 2.0;         ///< [s] cells without an echo for this time are forgotten
    double free_weight = 2.0;    ///< evidence of a farther echo against a cell; an echo at the cell weighs 1
    double silent_weight = 0.7;  ///< evidence of silence against a cell
    double band = 0.008;         ///< [m] the cells of an echo begin this much before its range
    /// [m] Silence and far echoes clear no cells nearer than this: close faces reflect sound sideways.
    double near = 0.05;
    double threshold = 1.0;  ///< evidence that makes a cell occupied
    double most = 4.0;       ///< greatest evidence
  };

  explicit EchoMap(const Settings& settings);
  /// Forgets everything.
  void reset();
  /// Takes the scene's readings of one tick into the grid.
  void update(const NavigationScene& scene);

  /// Nearest occupied cell within `range` [m] in every sector about `pose`, in the robot's frame.
  void scan(const SectorCircle& circle, const Pose2& pose, double range, std::span<SectorHit> hits) const;
  /// Appends discs that cover the occupied cells: at most one per square of `kDiscCells` x `kDiscCells`
  /// cells.
  void appendDiscs(std::vector<DiscObstacle>& discs) const;

  static constexpr int kDiscCells = 3;

 private:
  struct Cell {
    float evidence = 0.0f;  ///< positive: occupied, negative: free
    std::int32_t tick = 0;  ///< tick of the last echo from this cell
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
  int size_;    ///< used cells per side
  int stride_;  ///< stored cells per side, a power of two
  bool placed_ = false;
  int x_ = 0, y_ = 0;  ///< lowest cell of the grid
  Tick now_ = 0;
  Tick memory_ticks_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace fulbito
