#include "experiments/papers/transport/contour_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace fulbito {
namespace {

/// Sides of a cell: at the smaller and larger coordinates of the lead, then of the follower.
enum CellSide : int { kLeadLow, kLeadHigh, kFollowerLow, kFollowerHigh };

struct Cell {
  std::int64_t lead = 0;
  std::int64_t follower = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

class Walker {
 public:
  Walker(const TransportTask& task, double cell);
  ContourEnd run();

 private:
  double coordinate(std::int64_t node) const { return static_cast<double>(node) * cell_; }
  Vec2 pointAt(std::int64_t node) { return points_[static_cast<std::size_t>(node)]; }
  double excess(std::int64_t lead, std::int64_t follower) {
    return squaredNorm(pointAt(lead) - pointAt(follower)) - squared_;
  }
  bool crossed(const Cell& cell, int side);
  std::vector<int> crossings(const Cell& cell);
  int firstSide();
  int exit(const Cell& cell, int from);
  double excessInMiddle(const Cell& cell) const;
  static Cell neighbour(const Cell& cell, int side);
  bool outside(const Cell& cell) const;
  ContourEnd leaving(const Cell& cell, int side) const;

  const TransportTask& task_;
  std::int64_t count_;  // number of cells along each coordinate
  double cell_;
  double squared_;
  std::vector<Vec2> points_;
};

Walker::Walker(const TransportTask& task, double cell)
    : task_(task),
      count_(static_cast<std::int64_t>(std::ceil(task.path.length() / cell))),
      cell_(task.path.length() / static_cast<double>(count_)),
      squared_(task.rod * task.rod) {
  for (std::int64_t i = 0; i <= count_; ++i) points_.push_back(task.path.pose(coordinate(i)).position);
}

bool Walker::crossed(const Cell& cell, int side) {
  const std::int64_t i = cell.lead, j = cell.follower;
  const auto differ = [&](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return (excess(a, b) < 0.0) != (excess(c, d) < 0.0);
  };
  switch (side) {
    case kLeadLow:
      return differ(i, j, i, j + 1);
    case kLeadHigh:
      return differ(i + 1, j, i + 1, j + 1);
    case kFollowerLow:
      return differ(i, j, i + 1, j);
    default:
      return differ(i, j + 1, i + 1, j + 1);
  }
}

std::vector<int> Walker::crossings(const Cell& cell) {
  std::vector<int> sides;
  for (int side = kLeadLow; side <= kFollowerHigh; ++side) {
    if (crossed(cell, side)) sides.push_back(side);
  }
  return sides;
}

double Walker::excessInMiddle(const Cell& cell) const {
  const Vec2 lead = task_.path.pose(coordinate(cell.lead) + cell_ / 2).position;
  const Vec2 follower = task_.path.pose(coordinate(cell.follower) + cell_ / 2).position;
  return squaredNorm(lead - follower) - squared_;
}

// With four crossings, the middle decides which corners belong together.
int Walker::exit(const Cell& cell, int from) {
  const std::vector<int> sides = crossings(cell);
  if (sides.size() == 2) return sides[0] == from ? sides[1] : sides[0];
  const bool first_corner = excess(cell.lead, cell.follower) < 0.0;
  const bool joined = first_corner == (excessInMiddle(cell) < 0.0);  // with the opposite corner
  constexpr std::array<int, 4> kCutOff{kFollowerHigh, kFollowerLow, kLeadHigh, kLeadLow};
  constexpr std::array<int, 4> kKept{kFollowerLow, kFollowerHigh, kLeadLow, kLeadHigh};
  return (joined ? kCutOff : kKept)[static_cast<std::size_t>(from)];
}

Cell Walker::neighbour(const Cell& cell, int side) {
  switch (side) {
    case kLeadLow:
      return {cell.lead - 1, cell.follower};
    case kLeadHigh:
      return {cell.lead + 1, cell.follower};
    case kFollowerLow:
      return {cell.lead, cell.follower - 1};
    default:
      return {cell.lead, cell.follower + 1};
  }
}

bool Walker::outside(const Cell& cell) const {
  return cell.lead < 0 || cell.follower < 0 || cell.lead >= count_ || cell.follower >= count_;
}

ContourEnd Walker::leaving(const Cell& cell, int side) const {
  constexpr CurveEnd kEnds[] = {CurveEnd::kLeadAtStart, CurveEnd::kArrived, CurveEnd::kFollowerAtStart,
                                CurveEnd::kFollowerAtEnd};
  return {kEnds[side], coordinate(cell.lead), coordinate(cell.follower)};
}

int opposite(int side) { return side ^ 1; }

ContourEnd Walker::run() {
  const auto cell_of = [&](double q) {
    return std::clamp(static_cast<std::int64_t>(q / cell_), std::int64_t{0}, count_ - 1);
  };
  const Cell start{cell_of(task_.lead), cell_of(task_.follower)};
  Cell cell = start;
  // Leave the start's cell in the direction of travel.
  const RodView view = viewRod(task_.path, {task_.path.partAt(task_.lead), task_.lead},
                               {task_.path.partAt(task_.follower), task_.follower});
  const double sign = travelSign(task_), lead = sign * view.follower, follower = sign * view.lead;
  const auto progress = [&](int side) {
    const double ways[] = {-lead, lead, -follower, follower};
    return ways[side];
  };
  std::vector<int> sides = crossings(cell);
  if (sides.empty()) return {};
  int side =
      *std::max_element(sides.begin(), sides.end(), [&](int a, int b) { return progress(a) < progress(b); });
  const std::int64_t most = 400 * (count_ + 1);
  for (std::int64_t i = 0; i < most; ++i) {
    const Cell next = neighbour(cell, side);
    if (outside(next)) return leaving(cell, side);
    cell = next;
    side = exit(cell, opposite(side));
  }
  return {};
}

}  // namespace

ContourEnd walkContour(const TransportTask& task, double cell) { return Walker(task, cell).run(); }

}  // namespace fulbito
