#pragma once

#include <cstdint>
#include <vector>

#include "navigation/obstacles/range_smoother.hpp"

namespace fulbito {

/// A grid of what smoothed ranges prove about the surroundings. It moves with the robot and stays aligned
/// with the world. Each reading proves that its cone is free up to the range and that something is on the arc
/// at its end. The cones of readings from many places clear the wrong parts of the arcs.
///
/// - If a known surface explains an arc, the other cells on it gain only a tenth.
/// - Only near readings make a cell certain, since far arcs are as wide as a robot.
/// - A surface seen at an angle reflects the sound away. So readings do not clear a certain cell from
///   directions in which it would give no echo, and each cell stores from which directions it was seen free.
class ProvenMap {
 public:
  struct Cell {
    float evidence = 0.0f;     ///< positive: a surface, negative: free
    float x = 0.0f, y = 0.0f;  ///< mean direction toward the sensors that heard it, about a unit vector
    std::int32_t tick = 0;     ///< tick of the last echo
    std::uint32_t seen = 0;    ///< bit i: seen free from direction i of 32
  };

  /// @param cell  [m] side of a cell
  explicit ProvenMap(double cell) : cell_(cell), cells_(std::size_t{kStride} * kStride) {}
  /// Forgets everything.
  void reset();
  /// Moves the grid with the robot. Cells that enter the grid are unknown.
  void centre(Vec2 position, Tick now);
  /// Takes a reading into the grid. `share` (0 ... 1) is its new information since the sensor's last reading.
  void takeIn(const SmoothRange& reading, double share);
  /// Marks the cells of the robot's body as free, since nothing else can be there.
  void clearBody(const NavigationScene& scene);

  double cell() const { return cell_; }
  int cellOf(double coordinate) const;
  Vec2 middle(int x, int y) const { return {(x + 0.5) * cell_, (y + 0.5) * cell_}; }
  const Cell& at(int x, int y) const { return cells_[indexOf(x, y)]; }
  bool isOccupied(const Cell& cell) const { return cell.evidence > kOccupied && now_ - cell.tick < kMemory; }
  bool isCertain(const Cell& cell) const { return cell.evidence > kCertain && isOccupied(cell); }
  /// The directions near that of `toward`, as a mask for `Cell::seen`.
  static std::uint32_t about(Vec2 toward);
  /// Whether the cell was seen free from a direction near that of `toward`.
  static bool isProven(const Cell& cell, Vec2 toward) { return (cell.seen & about(toward)) != 0; }
  /// Calls `work(x, y, cell)` for the occupied cells in the square of half side `reach` [m] about `place`.
  template <typename Work>
  void forOccupied(Vec2 place, double reach, const Work& work) const {
    for (int y = cellOf(place.y - reach); y <= cellOf(place.y + reach); ++y) {
      for (int x = cellOf(place.x - reach); x <= cellOf(place.x + reach); ++x) {
        if (isOccupied(at(x, y))) work(x, y, at(x, y));
      }
    }
  }

 private:
  static constexpr int kSize = 160;    // used cells per side
  static constexpr int kStride = 256;  // stored cells per side, a power of two
  static constexpr float kOccupied = 3.0f, kCertain = 6.0f;
  static constexpr Tick kMemory = 3600;
  struct Call;

  static std::size_t indexOf(int x, int y) {
    return static_cast<std::size_t>(y & (kStride - 1)) * kStride +
           static_cast<std::size_t>(x & (kStride - 1));
  }
  template <typename Work>
  void forCone(const Call& call, const Work& work);
  void clear(const Call& call, Cell& cell, Vec2 to, double far) const;
  void raise(const Call& call, Cell& cell, Vec2 to) const;

  double cell_;
  bool placed_ = false;
  int x_ = 0, y_ = 0;  ///< lowest cell of the grid
  Tick now_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace fulbito
