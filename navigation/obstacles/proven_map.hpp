#pragma once

#include <cstdint>
#include <vector>

#include "navigation/obstacles/range_smoother.hpp"

namespace fulbito {

/// What smoothed ranges prove about the surroundings, whatever they are made of: a grid that moves with the
/// robot and stays aligned with the world. Each reading proves its cone free up to the range, and that
/// something stands on the arc at its end. Cones from many places leave of the arcs what is there.
///
///  - On an arc that a known surface explains, other cells gain a tenth.
///  - Only near readings make a cell certain: far arcs are as wide as a robot.
///  - A face throws sound off sideways where it is seen aslant. So a certain cell is not cleared from
///    directions in which it would not be heard, and each cell remembers from where it was seen free.
class ProvenMap {
 public:
  struct Cell {
    float evidence = 0.0f;     ///< for a surface > 0, against < 0
    float x = 0.0f, y = 0.0f;  ///< toward the sensors that heard it, about a unit vector
    std::int32_t tick = 0;     ///< when it was last heard
    std::uint32_t seen = 0;    ///< a bit for each of 32 directions from which it was seen free
  };

  /// @param cell  [m] side of a cell
  explicit ProvenMap(double cell) : cell_(cell), cells_(std::size_t{kStride} * kStride) {}
  /// Forgets everything.
  void reset();
  /// Moves the grid along with the robot. Cells that enter it are unknown.
  void centre(Vec2 position, Tick now);
  /// Takes in a reading. `share` (0 ... 1): how much it tells that the last one from the same sensor did not.
  void takeIn(const SmoothRange& reading, double share);
  /// Where the robot stands, nothing else does.
  void clearBody(const NavigationScene& scene);

  double cell() const { return cell_; }
  int cellOf(double coordinate) const;
  Vec2 middle(int x, int y) const { return {(x + 0.5) * cell_, (y + 0.5) * cell_}; }
  const Cell& at(int x, int y) const { return cells_[indexOf(x, y)]; }
  bool isOccupied(const Cell& cell) const { return cell.evidence > kOccupied && now_ - cell.tick < kMemory; }
  bool isCertain(const Cell& cell) const { return cell.evidence > kCertain && isOccupied(cell); }
  /// The directions about that of `toward`, as a mask of `Cell::seen`.
  static std::uint32_t about(Vec2 toward);
  /// Whether the cell was seen free from about the direction of `toward`.
  static bool isProven(const Cell& cell, Vec2 toward) { return (cell.seen & about(toward)) != 0; }
  /// Calls `work(x, y, cell)` for the occupied cells of the square of half side `reach` [m] about `place`.
  template <typename Work>
  void forOccupied(Vec2 place, double reach, const Work& work) const {
    for (int y = cellOf(place.y - reach); y <= cellOf(place.y + reach); ++y) {
      for (int x = cellOf(place.x - reach); x <= cellOf(place.x + reach); ++x) {
        if (isOccupied(at(x, y))) work(x, y, at(x, y));
      }
    }
  }

 private:
  static constexpr int kSize = 160;    // cells a side that are used
  static constexpr int kStride = 256;  // that are kept, a power of two
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
  int x_ = 0, y_ = 0;  ///< the grid's lowest cell
  Tick now_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace fulbito
