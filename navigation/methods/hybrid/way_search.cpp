#include "navigation/methods/hybrid/way_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr int kReach = 16;           // cells to which distances are known
constexpr double kTight = 0.987;     // of half the width: what a surface leaves free at least
constexpr double kWide = 2.13;       // of half the width: where its cost begins
constexpr double kNearCost = 4.0;    // that a tight place adds
constexpr double kUncertain = 2.5;   // cost of a place that only uncertain surfaces block
constexpr double kSuspect = 4.0;     // of one that a face may go on through
constexpr double kUnproven = 1.5;    // of one that was not seen free from where the way comes
constexpr double kStuck = 20.0;      // of one that is blocked, but the robot stands there
constexpr double kStuckReach = 8.0;  // cells about the robot for that
constexpr double kBody = 0.59;       // of half the width: nearer it cannot stand
constexpr double kLastShare = 0.7;   // cost of the last way
constexpr int kLastReach = 3;        // cells beside it
constexpr float kOutside = 1.5f;     // cost outside of the window
constexpr int kExtension = 50;       // cells by which a face goes on
constexpr int kStraight = 5;         // of the 6 cells before, to be a face
constexpr int kFaceReach = 7;        // cells about one that show a face's direction
constexpr int kSuspectReach = 7;     // cells
constexpr float kNever = 1e9f;

constexpr std::array<int, 16> kStepX{1, -1, 0, 0, 1, 1, -1, -1, 2, 2, -2, -2, 1, 1, -1, -1};
constexpr std::array<int, 16> kStepY{0, 0, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 2, -2, 2, -2};

int rounded(double value) { return static_cast<int>(std::floor(value + 0.5)); }

}  // namespace

WaySearch::WaySearch() {
  constexpr std::size_t kCells = std::size_t{kSide} * kSide;
  for (auto* each : {&any_, &certain_, &cost_}) each->resize(kCells);
  suspect_.resize(kCells), last_.resize(kCells), parent_.resize(kCells);
  for (std::size_t k = 0; k < kStepX.size(); ++k) {
    const Vec2 step{static_cast<double>(kStepX[k]), static_cast<double>(kStepY[k])};
    step_[k] = norm(step), whence_[k] = ProvenMap::about(-step);
  }
  open_.reserve(4 * kCells), path_.reserve(kCells);
  for (int y = 0; y <= kReach; ++y) {
    for (int x = 0; x <= kReach; ++x) table_.push_back(std::sqrt(static_cast<float>(x * x + y * y)));
  }
}

void WaySearch::search(const ProvenMap& map, Vec2 from, Vec2 goal, double half_width) {
  half_width_ = half_width / map.cell();
  x_ = map.cellOf(from.x) - kSide / 2, y_ = map.cellOf(from.y) - kSide / 2;
  measure(map);
  markLast(map);
  path_.clear();
  for (int i = expand(map, from, goal); i >= 0; i = parent_[static_cast<std::size_t>(i)])
    path_.push_back(map.middle(x_ + i % kSide, y_ + i / kSide));
  std::reverse(path_.begin(), path_.end());
  if (!path_.empty()) path_.front() = from;
}

double WaySearch::clearance(const ProvenMap& map, Vec2 place) const {
  const int x = map.cellOf(place.x) - x_, y = map.cellOf(place.y) - y_;
  if (!isInside(x, y)) return kReach * map.cell();
  return static_cast<double>(any_[static_cast<std::size_t>(indexOf(x, y))]) * map.cell();
}

void WaySearch::measure(const ProvenMap& map) {
  std::fill(any_.begin(), any_.end(), static_cast<float>(kReach));
  std::fill(certain_.begin(), certain_.end(), static_cast<float>(kReach));
  std::fill(suspect_.begin(), suspect_.end(), std::uint8_t{0});
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const ProvenMap::Cell& cell = map.at(x_ + x, y_ + y);
      if (!map.isOccupied(cell)) continue;
      stamp(x, y, map.isCertain(cell));
      extend(map, x, y, cell);
    }
  }
}

void WaySearch::stamp(int x, int y, bool certain) {
  for (int v = std::max(0, y - kReach); v <= std::min(kSide - 1, y + kReach); ++v) {
    for (int u = std::max(0, x - kReach); u <= std::min(kSide - 1, x + kReach); ++u) {
      const float far = table_[static_cast<std::size_t>(std::abs(v - y)) * (kReach + 1) +
                               static_cast<std::size_t>(std::abs(u - x))];
      const auto i = static_cast<std::size_t>(indexOf(u, v));
      any_[i] = std::min(any_[i], far);
      if (certain) certain_[i] = std::min(certain_[i], far);
    }
  }
}

/// The normal of the line through the occupied cells about a cell, on the side of `heard`. Sensors hear faces
/// aslant, so the direction from which a cell was heard is no normal.
Vec2 WaySearch::normalAt(const ProvenMap& map, int x, int y, Vec2 heard) const {
  double count = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  Vec2 sum;
  for (int v = -kFaceReach; v <= kFaceReach; ++v) {
    for (int u = -kFaceReach; u <= kFaceReach; ++u) {
      if (u * u + v * v > kFaceReach * kFaceReach || !map.isOccupied(map.at(x_ + x + u, y_ + y + v)))
        continue;
      sum += Vec2{static_cast<double>(u), static_cast<double>(v)};
      xx += u * u, xy += u * v, yy += v * v, ++count;
    }
  }
  xx -= sum.x * sum.x / count, xy -= sum.x * sum.y / count, yy -= sum.y * sum.y / count;
  const double half = (xx - yy) / 2, spread = std::sqrt(half * half + xy * xy);
  const Vec2 along = half > 0.0 ? Vec2{half + spread, xy} : Vec2{xy, spread - half};
  const Vec2 normal = unitOr(perp(along), heard);
  return dot(normal, heard) < 0.0 ? -normal : normal;
}

/// Lets the face that `cell` belongs to go on to both sides, until two cells are proven free.
void WaySearch::extend(const ProvenMap& map, int x, int y, const ProvenMap::Cell& cell) {
  const Vec2 heard = unitOr({static_cast<double>(cell.x), static_cast<double>(cell.y)}, {1.0, 0.0});
  const Vec2 normal = normalAt(map, x, y, heard);
  const std::uint32_t front = ProvenMap::about(normal);
  for (const double side : {1.0, -1.0}) {
    const Vec2 along = perp(normal) * side;
    int straight = 0, proven = 0;
    for (int i = 1; i <= kStraight + 1; ++i) {
      bool any = false;
      for (int k = -1; k <= 1; ++k) {
        const Vec2 back = along * i + normal * k;
        any = any || map.isOccupied(map.at(x_ + x - rounded(back.x), y_ + y - rounded(back.y)));
      }
      straight += any ? 1 : 0;
    }
    for (int i = 1; straight >= kStraight && i <= kExtension && proven < 2; ++i) {
      const int u = x + rounded(along.x * i), v = y + rounded(along.y * i);
      if (!isInside(u, v)) break;
      const ProvenMap::Cell& next = map.at(x_ + u, y_ + v);
      if ((next.seen & front) != 0) {
        ++proven;
      } else if (!map.isOccupied(next)) {
        suspect(u, v);
      }
    }
  }
}

void WaySearch::suspect(int x, int y) {
  constexpr std::uint8_t kCentre = 2, kNear = 1;
  std::uint8_t& centre = suspect_[static_cast<std::size_t>(indexOf(x, y))];
  if (centre == kCentre) return;
  centre = kCentre;
  for (int v = std::max(0, y - kSuspectReach); v <= std::min(kSide - 1, y + kSuspectReach); ++v) {
    for (int u = std::max(0, x - kSuspectReach); u <= std::min(kSide - 1, x + kSuspectReach); ++u) {
      const bool near = (u - x) * (u - x) + (v - y) * (v - y) <= kSuspectReach * kSuspectReach;
      std::uint8_t& cell = suspect_[static_cast<std::size_t>(indexOf(u, v))];
      if (near) cell = std::max(cell, kNear);
    }
  }
}

void WaySearch::markLast(const ProvenMap& map) {
  std::fill(last_.begin(), last_.end(), std::uint8_t{0});
  for (const Vec2 place : path_) {
    const int x = map.cellOf(place.x) - x_, y = map.cellOf(place.y) - y_;
    for (int v = y - kLastReach; v <= y + kLastReach; ++v) {
      for (int u = x - kLastReach; u <= x + kLastReach; ++u) {
        if (isInside(u, v)) last_[static_cast<std::size_t>(indexOf(u, v))] = 1;
      }
    }
  }
}

/// Cost of a cell a cell; 0 where it is blocked.
double WaySearch::weight(int index, int from_start2) const {
  const auto i = static_cast<std::size_t>(index);
  const double any = static_cast<double>(any_[i]), certain = static_cast<double>(certain_[i]);
  const double tight = kTight * half_width_, wide = kWide * half_width_;
  double weight = 1.0;
  if (certain < tight) {
    if (from_start2 > kStuckReach * kStuckReach || certain < kBody * half_width_) return 0.0;
    weight = kStuck;
  } else if (any < tight) {
    weight = kUncertain;
  } else if (any < wide) {
    const double near = (wide - any) / (wide - tight);
    weight = 1.0 + kNearCost * near * near;
  }
  if (suspect_[i] != 0) weight = std::max(weight, kSuspect);
  return last_[i] != 0 ? weight * kLastShare : weight;
}

void WaySearch::visit(const Node& node, float rest, int index, float length) {
  const auto i = static_cast<std::size_t>(index);
  const float cost = node.cost + length;
  if (cost >= cost_[i]) return;
  cost_[i] = cost, parent_[i] = node.index;
  open_.push_back({cost + rest, cost, index});
  std::push_heap(open_.begin(), open_.end(), [](const Node& a, const Node& b) {
    return a.total != b.total ? a.total > b.total : a.index > b.index;
  });
}

/// The last cell of the cheapest way; -1 without one.
int WaySearch::expand(const ProvenMap& map, Vec2 from, Vec2 goal) {
  const int goal_x = map.cellOf(goal.x) - x_, goal_y = map.cellOf(goal.y) - y_;
  const int start_x = map.cellOf(from.x) - x_, start_y = map.cellOf(from.y) - y_;
  std::fill(cost_.begin(), cost_.end(), kNever);
  open_.clear();
  visit({0.0f, 0.0f, -1}, 0.0f, indexOf(start_x, start_y), 0.0f);
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), [](const Node& a, const Node& b) {
      return a.total != b.total ? a.total > b.total : a.index > b.index;
    });
    const Node node = open_.back();
    open_.pop_back();
    if (node.cost > cost_[static_cast<std::size_t>(node.index)]) continue;
    const int x = node.index % kSide, y = node.index / kSide;
    const auto is_edge = [](int u, int v) { return u == 0 || v == 0 || u == kSide - 1 || v == kSide - 1; };
    if ((x == goal_x && y == goal_y) || is_edge(x, y)) return node.index;
    for (std::size_t k = 0; k < kStepX.size(); ++k) {
      const int u = x + kStepX[k], v = y + kStepY[k];
      if (!isInside(u, v)) continue;
      // Nothing costs less than the last way: most neighbours are known cheaper already.
      const float known = cost_[static_cast<std::size_t>(indexOf(u, v))];
      if (node.cost + static_cast<float>(step_[k] * kLastShare) >= known) continue;
      const double clear =
          weight(indexOf(u, v), (u - start_x) * (u - start_x) + (v - start_y) * (v - start_y));
      if (clear == 0.0) continue;
      const ProvenMap::Cell& cell = map.at(x_ + u, y_ + v);
      const double each = clear * ((cell.seen & whence_[k]) != 0 ? 1.0 : kUnproven);
      const auto length = static_cast<float>(step_[k] * each);
      if (node.cost + length >= known) continue;
      const double left = norm({static_cast<double>(u - goal_x), static_cast<double>(v - goal_y)});
      const float rest =
          static_cast<float>(left) * (is_edge(u, v) ? kOutside : static_cast<float>(kLastShare));
      visit(node, rest, indexOf(u, v), length);
    }
  }
  return -1;
}

}  // namespace fulbito
